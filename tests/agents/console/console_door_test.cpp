// Who is let in, and who is not.

#include <algorithm>
#include <ranges>

#include "tests/agents/console/console_fixture.hpp"

namespace pizarra::console {
namespace {

TEST_F(ConsoleTest, GivesThePageUnderAPolicyThatLetsNothingElseRun) {
  const std::string answer = head("GET", "/", {{"Origin", ""}});
  EXPECT_TRUE(begins(answer, "HTTP/1.1 200"));
  EXPECT_TRUE(has(answer, "default-src 'none'; script-src 'self'; style-src 'self'"));
  EXPECT_TRUE(has(answer, "require-trusted-types-for 'script'"));
  EXPECT_FALSE(has(answer, "unsafe"));
  EXPECT_TRUE(has(answer, "X-Content-Type-Options: nosniff"));
}

TEST_F(ConsoleTest, RefusesANameThatIsNotItsOwnWhateverItResolvesTo) {
  EXPECT_TRUE(begins(head("GET", "/", {{"Host", "evil.example:80"}}), "HTTP/1.1 421"));
  EXPECT_TRUE(begins(head("GET", "/", {{"Host", "127.0.0.1:1"}}), "HTTP/1.1 421"));
  Headers upgrade = upgrade_headers(cookie());
  upgrade["Host"] = "evil.example";
  EXPECT_TRUE(begins(head("GET", "/socket", upgrade), "HTTP/1.1 421"));
}

TEST_F(ConsoleTest, RefusesWhatAnotherOriginsPageHasABrowserAsk) {
  const Headers foreign{{"Origin", "http://evil.example"}};
  EXPECT_TRUE(begins(head("GET", "/", foreign), "HTTP/1.1 403"));
  EXPECT_TRUE(
      begins(head("POST", "/session", {{"Origin", "null"}, {"Authorization", "Bearer " + token_}}), "HTTP/1.1 403"));
  Headers upgrade = upgrade_headers(cookie());
  upgrade["Origin"] = "http://127.0.0.1:1";
  EXPECT_TRUE(begins(head("GET", "/socket", upgrade), "HTTP/1.1 403"));
  upgrade["Origin"] = "";
  EXPECT_TRUE(begins(head("GET", "/socket", upgrade), "HTTP/1.1 403"));
}

TEST_F(ConsoleTest, TellsAnAddressThatHasItsShareOfConnectionsSo) {
  web::HttpServer::Place place;
  place.max_of_address = 2;
  const auto server =
      web::HttpServer::listen(executor_, place, [](const web::HttpRequest&) { return web::HttpAnswer{}; }).value();
  const auto ask = [&](RawClient& client) {
    return serve([&, port = server->port()] {
      client.send(request_text(port, "GET", "/", {}));
      return client.read_head();
    });
  };
  auto first = std::make_unique<RawClient>(server->port());
  RawClient second(server->port());
  EXPECT_TRUE(begins(ask(*first), "HTTP/1.1 200"));
  EXPECT_TRUE(begins(ask(second), "HTTP/1.1 200"));
  RawClient third(server->port());
  EXPECT_TRUE(begins(ask(third), "HTTP/1.1 503"));
  first.reset();
  const auto is_let_in = [&] {
    RawClient fourth(server->port());
    return ask(fourth).starts_with("HTTP/1.1 200");
  };
  EXPECT_TRUE(std::ranges::any_of(std::views::iota(0, 100), [&](int) { return is_let_in(); })) << "there is room again";
}

TEST_F(ConsoleTest, ExchangesATokenOnceForACookieThatScriptsDoNotSee) {
  const Headers right{{"Authorization", "Bearer " + token_}};
  const std::string answer = head("POST", "/session", right);
  EXPECT_TRUE(begins(answer, "HTTP/1.1 204"));
  EXPECT_TRUE(has(answer, "HttpOnly; SameSite=Strict; Path=/socket"));
  EXPECT_TRUE(begins(head("POST", "/session", right), "HTTP/1.1 403")) << "a second time";
  EXPECT_FALSE(has(console_->address(), token_));
}

TEST_F(ConsoleTest, RefusesAWrongToken) {
  std::string wrong = token_;
  wrong.back() = wrong.back() == '0' ? '1' : '0';
  EXPECT_TRUE(begins(head("POST", "/session", {{"Authorization", "Bearer " + wrong}}), "HTTP/1.1 403"));
  EXPECT_TRUE(begins(head("POST", "/session", {{"Authorization", "Bearer "}}), "HTTP/1.1 403"));
  EXPECT_TRUE(begins(head("POST", "/session"), "HTTP/1.1 403"));
  EXPECT_TRUE(begins(head("GET", "/session", {{"Authorization", "Bearer " + token_}}), "HTTP/1.1 405"));
}

TEST_F(ConsoleTest, UpgradesNobodyWithoutACookieOfIts) {
  EXPECT_TRUE(begins(head("GET", "/socket", upgrade_headers("")), "HTTP/1.1 403"));
  const std::string own = cookie();
  const std::string name = own.substr(0, own.find('='));
  EXPECT_TRUE(begins(head("GET", "/socket", upgrade_headers(name + "=" + std::string(64, '0'))), "HTTP/1.1 403"));
  EXPECT_TRUE(begins(head("GET", "/socket", upgrade_headers(name + "=")), "HTTP/1.1 403"));
  EXPECT_TRUE(begins(head("GET", "/socket", upgrade_headers("other=1; " + own)), "HTTP/1.1 101"));
}

TEST_F(ConsoleTest, AnswersTheHandshakeAsTheStandardsExampleHasIt) {
  const std::string answer = head("GET", "/socket", upgrade_headers(cookie()));
  EXPECT_TRUE(has(answer, "Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo="));
}

TEST_F(ConsoleTest, TakesNoBodyAndNoEndlessHead) {
  EXPECT_TRUE(begins(head("POST", "/session", {{"Content-Length", "1000000"}}), "HTTP/1.1 413"));
  EXPECT_FALSE(begins(head("GET", "/", {{"X-Long", std::string(100'000, 'x')}}), "HTTP/1.1 200"));
  EXPECT_TRUE(begins(head("GET", "/../CMakeLists.txt"), "HTTP/1.1 404"));
  EXPECT_TRUE(begins(head("GET", "/"), "HTTP/1.1 200")) << "and goes on";
}

TEST_F(ConsoleTest, EndsASessionWhenItsTimeIsOver) {
  Access access({.port = 1});
  const std::optional<std::string> secret = access.exchange(access.token(), Time(0s));
  ASSERT_TRUE(secret);
  const std::string shown = access.cookie_name() + "=" + *secret;
  EXPECT_TRUE(access.admitted(shown, Time(Access::session_length - 1s)));
  EXPECT_FALSE(access.admitted(shown, Time(Access::session_length)));
}

TEST_F(ConsoleTest, EndsEveryPageOfASessionThatIsLoggedOutAndNoOther) {
  const std::string own = cookie();
  const auto one = page(own);
  const auto another = page(own);
  token_ = console_->address().substr(console_->address().find('#') + 1);
  const auto others = page(cookie());
  EXPECT_TRUE(begins(head("DELETE", "/socket", {{"Cookie", own}, {"Origin", ""}}), "HTTP/1.1 403"));
  EXPECT_EQ(console_->pages(), 3u);
  EXPECT_TRUE(begins(head("DELETE", "/socket", {{"Cookie", own}}), "HTTP/1.1 204"));
  executor_.run_until([&] { return console_->pages() == 1 || tick(); });
  EXPECT_TRUE(begins(head("GET", "/socket", upgrade_headers(own)), "HTTP/1.1 403"));
}

TEST_F(ConsoleTest, HoldsSoManySessionsAndNoMore) {
  Access access({.port = 1});
  std::vector<std::string> cookies;
  for (std::size_t i = 0; i <= Access::max_sessions; ++i) {
    const Time now(Duration(static_cast<std::int64_t>(i)));
    cookies.push_back(access.cookie_name() + "=" + access.exchange(access.token(), now).value());
  }
  EXPECT_FALSE(access.admitted(cookies.front(), Time(1s))) << "the one that would have ended first";
  EXPECT_TRUE(access.admitted(cookies[1], Time(1s)));
  EXPECT_TRUE(access.admitted(cookies.back(), Time(1s)));
}

TEST_F(ConsoleTest, LetsAViewerReadByItsOwnTokenAndOrigin) {
  const std::string address = console_->foxglove_address();
  const std::string path = address.substr(address.find("/foxglove"));
  const auto asked = [&](const std::string& where, const Headers& other) {
    Headers headers = upgrade_headers("");
    headers["Sec-WebSocket-Protocol"] = "other, foxglove.websocket.v1";
    for (const auto& [name, value] : other) headers[name] = value;
    return head("GET", where, headers);
  };
  EXPECT_TRUE(begins(asked("/foxglove", {{"Origin", ""}}), "HTTP/1.1 403"));
  EXPECT_TRUE(begins(asked("/foxglove?token=" + token_, {{"Origin", ""}}), "HTTP/1.1 403")) << "a page's token";
  EXPECT_TRUE(begins(asked(path, {{"Origin", "https://evil.example"}}), "HTTP/1.1 403"));
  EXPECT_TRUE(begins(asked(path, {{"Origin", ""}, {"Host", "evil.example"}}), "HTTP/1.1 421"));
  EXPECT_TRUE(begins(asked(path, {{"Origin", ""}, {"Sec-WebSocket-Protocol", "other"}}), "HTTP/1.1 400"));
  EXPECT_EQ(console_->viewers(), 0u);
  const std::string answer = asked(path, {{"Origin", ""}});
  EXPECT_TRUE(begins(answer, "HTTP/1.1 101"));
  EXPECT_TRUE(has(answer, "Sec-WebSocket-Protocol: foxglove.websocket.v1"));
  EXPECT_TRUE(begins(asked(path, {{"Origin", "https://viewer.example"}}), "HTTP/1.1 101")) << "and another";
}

TEST_F(ConsoleTest, AnswersAViewerThatAsksForFarTooMuchOnce) {
  const std::string address = console_->foxglove_address();
  std::string wanted = "1";
  for (int i = 0; i < 2000; ++i) wanted += ",1";
  const std::vector<std::string> heard = serve([&] {
    RawClient viewer(port_);
    Headers headers = upgrade_headers("");
    headers["Sec-WebSocket-Protocol"] = "foxglove.websocket.v1";
    headers["Origin"] = "";
    viewer.send(request_text(port_, "GET", address.substr(address.find("/foxglove")), headers));
    viewer.read_head();
    viewer.send_frame(RawClient::text, R"({"op":"subscribe","subscriptions":[)" + wanted + "]}");
    viewer.send_frame(RawClient::text, R"({"op":"publish"})");
    std::vector<std::string> frames;
    while (frames.size() < 4) frames.push_back(viewer.read_frame().value().payload);
    return frames;
  });
  EXPECT_TRUE(has(heard[2], "too many subscriptions in one message"));
  EXPECT_TRUE(has(heard[3], "subscribes and unsubscribes here, and nothing else"));
}

}  // namespace
}  // namespace pizarra::console
