// Who comes from another machine: with the token of a key, for as long as that token is there.

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "agents/console/access.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/wire/keys.hpp"
#include "blackboard/wire/tokens.hpp"
#include "drivers/web/http_server.hpp"
#include "tests/scratch.hpp"

namespace pizarra::console {
namespace {

class AccessFromAbroad : public testing::Test {
 protected:
  AccessFromAbroad() : folder_(scratch_folder() + "tokens") {
    std::filesystem::remove_all(folder_);
    EXPECT_TRUE(wire::make_keys(folder_, "anna", {}));
    EXPECT_TRUE(wire::make_keys(folder_, "board", {}));
  }
  Access access() const { return Access({.port = 8443, .secure = true, .hosts = {"cell.lab"}, .tokens = folder_}); }
  std::string refusal(const std::string& name) const { return wire::make_token(folder_, name).error().symbol; }

  const std::string folder_;
};

TEST_F(AccessFromAbroad, GivesASessionOfTheKeyWhoseTokenIsShown) {
  const std::string token = wire::make_token(folder_, "anna").value();
  Access door = access();
  const auto secret = door.exchange(token, Time(0s));
  ASSERT_TRUE(secret);
  const std::string cookie = door.cookie_name() + "=" + *secret;
  const auto session = door.admitted(cookie, Time(1s));
  ASSERT_TRUE(session);
  EXPECT_EQ(session->key, "anna");
  EXPECT_EQ(session->until, Time(Access::session_length));
  EXPECT_TRUE(door.exchange(token, Time(1s))) << "another browser of the same person";
  door.forget(cookie);
  EXPECT_FALSE(door.admitted(cookie, Time(1s))) << "after logging out";
}

TEST_F(AccessFromAbroad, RefusesEveryOtherToken) {
  const std::string token = wire::make_token(folder_, "anna").value();
  Access door = access();
  const std::string secret = token.substr(token.find('.') + 1);
  for (const std::string& wrong :
       {std::string(), std::string("."), std::string("anna"), std::string("anna."), "board." + secret,
        "../tokens/anna." + secret, "anna." + std::string(secret.size(), '0'), token + "0", secret, door.token()}) {
    EXPECT_FALSE(door.exchange(wrong, Time(0s))) << wrong;
  }
  EXPECT_TRUE(door.exchange(token, Time(0s)));
}

TEST_F(AccessFromAbroad, EndsWithTheToken) {
  const std::string token = wire::make_token(folder_, "anna").value();
  Access door = access();
  const std::string cookie = door.cookie_name() + "=" + door.exchange(token, Time(0s)).value();
  const std::string fresh = wire::make_token(folder_, "anna").value();
  EXPECT_FALSE(door.admitted(cookie, Time(1s))) << "another one was made";
  const std::string second = door.cookie_name() + "=" + door.exchange(fresh, Time(1s)).value();
  EXPECT_TRUE(door.admitted(second, Time(1s)));
  std::filesystem::permissions(folder_ + "/anna.token", std::filesystem::perms(0644));
  EXPECT_FALSE(door.admitted(second, Time(1s))) << "others may read it";
  std::filesystem::permissions(folder_ + "/anna.token", std::filesystem::perms(0600));
  EXPECT_TRUE(door.admitted(second, Time(1s)));
  std::ofstream(folder_ + "/anna.token") << "(token anna)";
  EXPECT_FALSE(door.admitted(second, Time(1s))) << "its file holds none";
  std::filesystem::remove(folder_ + "/anna.token");
  EXPECT_FALSE(door.admitted(second, Time(1s))) << "it was taken away";
}

TEST_F(AccessFromAbroad, AnOpenPagesSessionStandsAsLongAsItsToken) {
  const std::string token = wire::make_token(folder_, "anna").value();
  Access door = access();
  const std::string cookie = door.cookie_name() + "=" + door.exchange(token, Time(0s)).value();
  const std::uint64_t number = door.admitted(cookie, Time(0s))->number;
  EXPECT_TRUE(door.stands(number, Time(1s)));
  EXPECT_FALSE(door.stands(number + 1, Time(1s))) << "there is none of that number";
  EXPECT_FALSE(door.stands(number, Time(Access::session_length)));
  const std::string again = door.cookie_name() + "=" + door.exchange(token, Time(0s)).value();
  const std::uint64_t second = door.admitted(again, Time(0s))->number;
  ASSERT_TRUE(wire::make_token(folder_, "anna"));
  EXPECT_FALSE(door.stands(second, Time(1s))) << "another token was made";
}

TEST_F(AccessFromAbroad, WhoLogsInAgainAndAgainTakesTheRoomOfItsOwnSessions) {
  ASSERT_TRUE(wire::make_keys(folder_, "bert", {}));
  const std::string annas = wire::make_token(folder_, "anna").value();
  const std::string berts = wire::make_token(folder_, "bert").value();
  Access door = access();
  const auto log_in = [&](const std::string& token, Time now) {
    return door.cookie_name() + "=" + door.exchange(token, now).value();
  };
  const std::string bert = log_in(berts, Time(0s));
  const std::string first = log_in(annas, Time(1s));
  for (std::size_t i = 1; i < Access::max_sessions_of_a_key; ++i) log_in(annas, Time(2s));
  EXPECT_TRUE(door.admitted(first, Time(3s)));
  for (std::size_t i = 0; i < 2 * Access::max_sessions; ++i) log_in(annas, Time(3s));
  EXPECT_FALSE(door.admitted(first, Time(4s)));
  EXPECT_TRUE(door.admitted(bert, Time(4s))) << "another's session is left alone";
}

TEST_F(AccessFromAbroad, KnowsItsOwnNamesAlone) {
  const Access door = access();
  EXPECT_TRUE(door.is_own_host("cell.lab:8443"));
  EXPECT_TRUE(door.is_own_origin("https://cell.lab:8443", "cell.lab:8443"));
  EXPECT_FALSE(door.is_own_host("127.0.0.1:8443"));
  EXPECT_FALSE(door.is_own_host("cell.lab"));
  EXPECT_FALSE(door.is_own_origin("http://cell.lab:8443", "cell.lab:8443"));
  const Access usual({.port = 443, .secure = true, .hosts = {"cell.lab"}, .tokens = folder_});
  EXPECT_TRUE(usual.is_own_host("cell.lab"));
  EXPECT_TRUE(usual.is_own_origin("https://cell.lab", "cell.lab"));
}

TEST_F(AccessFromAbroad, MakesATokenForAKeyWhoseSecretIsThere) {
  EXPECT_EQ(refusal("bert"), "no-key");
  EXPECT_EQ(refusal("board"), "no-key");
  EXPECT_EQ(refusal("../anna"), "bad-name");
  ASSERT_TRUE(wire::make_token(folder_, "anna"));
  const auto may = std::filesystem::status(folder_ + "/anna.token").permissions();
  EXPECT_EQ(may, std::filesystem::perms(0600));
}

TEST(AServerAbroad, ListensWithACertificateAndItsKeyAlone) {
  RealExecutor executor;
  const auto refused = [&](const web::HttpServer::Place& place) {
    const auto server =
        web::HttpServer::listen(executor, place, [](const web::HttpRequest&) { return web::HttpAnswer{}; });
    return server ? std::string() : server.error().sentence;
  };
  EXPECT_NE(refused({"127.0.0.1", 0, "no certificate", "no key"}).find("no such pair"), std::string::npos);
  EXPECT_EQ(refused({"nowhere", 0}), "nowhere is no IP address");
  EXPECT_EQ(refused({}), "");
}

}  // namespace
}  // namespace pizarra::console
