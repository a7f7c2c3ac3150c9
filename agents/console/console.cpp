#include "agents/console/console.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pizarra::console {

namespace {

constexpr Duration longest_goodbye = 1s;
constexpr Duration between_looks_at_tokens = 1s;
// Four pages with all their connections, and what they ask for meanwhile.
constexpr unsigned max_of_address = 64;
constexpr std::string_view bearer = "Bearer ";
constexpr std::size_t web_socket_key_size = 24;
constexpr std::string_view lanes_path = "/socket/";

web::HttpAnswer plain(unsigned status, std::string sentence) {
  return {.status = status, .type = "text/plain; charset=utf-8", .body = std::move(sentence) + "\n"};
}

// The page's content policy. A page of another origin, or a fact that is shown, can make the browser do nothing.
std::string content_policy(const std::vector<std::string>& sockets) {
  return fmt::format(
      "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; "
      "connect-src 'self' {}; base-uri 'none'; form-action 'none'; "
      "frame-ancestors 'none'; require-trusted-types-for 'script'; trusted-types 'none'",
      fmt::join(sockets, " "));
}

bool asks_for_web_socket(const web::HttpRequest& request) {
  return request.method == "GET" && (request.upgrade == "websocket" || request.upgrade == "WebSocket") &&
         request.web_socket_version == "13" && request.web_socket_key.size() == web_socket_key_size;
}

// Nothing: a page that was let in asks for one.
std::optional<web::HttpAnswer> why_no_connection(const web::HttpRequest& request,
                                                 const std::optional<Access::Admitted>& session) {
  if (!session) return plain(403, "no session: open the address that the console printed");
  if (!asks_for_web_socket(request)) return plain(426, "here is a WebSocket alone");
  if (request.origin.empty()) return plain(403, "only the page may connect");
  return std::nullopt;
}

web::HttpAnswer web_socket_answer(const web::HttpRequest& request) {
  web::HttpAnswer answer{.status = 101};
  answer.headers = {{"Upgrade", "websocket"}, {"Sec-WebSocket-Accept", web::web_socket_accept(request.web_socket_key)}};
  return answer;
}

}  // namespace

Result<std::unique_ptr<Console>> Console::open(Setup setup) {
  Result<PageFiles> page = PageFiles::read(setup.page_folder);
  if (!page) return fail(page);
  web::HttpServer::Place place{.port = setup.port};
  Access::Door door;
  if (setup.abroad) {
    const Abroad& abroad = *setup.abroad;
    place = {abroad.address, setup.port, abroad.certificate, abroad.certificate_key, max_of_address};
    door = {.secure = true, .hosts = abroad.hosts, .tokens = abroad.tokens};
  }
  std::unique_ptr<Console> console(new Console(std::move(setup), std::move(*page)));
  Console* self = console.get();
  auto server = web::HttpServer::listen(self->setup_.executor, place,
                                        [self](const web::HttpRequest& request) { return self->answer(request); });
  if (!server) return fail(server);
  console->server_ = std::move(*server);
  door.port = console->server_->port();
  console->access_ = std::make_unique<Access>(std::move(door));
  if (self->setup_.abroad) self->ending_ = self->setup_.executor.spawn(self->end_pages_without_token());
  const Result<void> kept = console->keep_pictures();
  if (!kept) return fail(kept);
  const Result<void> followed = console->keep_changes();
  if (!followed) return fail(followed);
  const Result<void> wired = console->tell_wiring();
  if (!wired) return fail(wired);
  return console;
}

Console::Console(Setup setup, PageFiles page)
    : setup_(std::move(setup)),
      page_(std::move(page)),
      images_(setup_.executor, setup_.streams),
      truth_(setup_.executor, setup_.truth),
      emptied_(setup_.executor) {}

Console::~Console() = default;

Result<void> Console::keep_pictures() {
  if (setup_.pictures == nullptr) return {};
  Result<std::unique_ptr<Board>> board = setup_.board(setup_.name + "-pictures", "");
  if (!board) return fail(board);
  const auto trouble = [this](const Failure& failure) {
    if (setup_.trouble) setup_.trouble(failure);
  };
  keeper_ = std::make_unique<PictureKeeper>(
      PictureKeeper::Setup{setup_.executor, setup_.streams, std::move(*board), *setup_.pictures, trouble});
  return {};
}

Result<void> Console::keep_changes() {
  Result<std::unique_ptr<Board>> board = setup_.board(setup_.name + "-changes", "");
  if (!board) return fail(board);
  kept_ = std::make_unique<KeptChanges>(setup_.executor, std::move(*board), setup_.journal);
  return {};
}

Result<void> Console::tell_wiring() {
  Result<std::unique_ptr<Board>> board = setup_.board(Wiring::client, "");
  if (!board) return fail(board);
  wiring_ = std::make_unique<Wiring>(setup_.executor, std::move(*board), setup_.abroad ? address() : std::string());
  return {};
}

// Behind the #, so that no log and no other server ever sees it.
std::string Console::address() const {
  if (setup_.abroad) return fmt::format("https://{}/", host());
  return fmt::format("http://{}/#{}", host(), access_->token());
}

std::string Console::host() const {
  return fmt::format("{}:{}", setup_.abroad ? setup_.abroad->hosts.front() : "127.0.0.1", server_->port());
}

std::string Console::foxglove_address() const {
  return fmt::format("{}://{}/foxglove?token={}", setup_.abroad ? "wss" : "ws", host(), access_->reading_token());
}

Task<void> Console::close() {
  viewers_.clear();
  for (const auto& [number, page] : pages_) page.live->leave();
  const Time deadline = setup_.executor.now() + longest_goodbye;
  if (!pages_.empty()) co_await emptied_.wait(deadline);
  co_await wiring_->leave();
}

web::HttpAnswer Console::answer(const web::HttpRequest& request) {
  if (!access_->is_own_host(request.host)) return with_headers(plain(421, "this is no name of this server"));
  if (request.path == "/foxglove" && setup_.foxglove) return with_headers(open_viewer(request));
  const bool foreign = !request.origin.empty() && !access_->is_own_origin(request.origin, request.host);
  if (foreign) return with_headers(plain(403, "pages of another origin are not served"));
  if (request.path == "/session") return with_headers(exchange(request));
  if (request.path == "/socket") return with_headers(open_page(request));
  if (request.path.starts_with(lanes_path)) return with_headers(open_lane(request));
  if (request.method != "GET" && request.method != "HEAD") return with_headers(plain(405, "that cannot be done here"));
  const PageFile* file = page_.find(request.path);
  if (file == nullptr) return with_headers(plain(404, "there is nothing here"));
  return with_headers({.status = 200, .type = file->type, .body = file->text});
}

// POST /session with `Authorization: Bearer TOKEN`.
web::HttpAnswer Console::exchange(const web::HttpRequest& request) {
  if (request.method != "POST") return plain(405, "a token is exchanged by POST");
  if (request.origin.empty()) return plain(403, "a token is exchanged by the page alone");
  const std::string_view shown = request.authorization;
  if (!shown.starts_with(bearer)) return plain(403, "there is no token");
  const std::optional<std::string> cookie = access_->exchange(shown.substr(bearer.size()), setup_.executor.now());
  if (!cookie) return plain(403, "this token is wrong, or has been used");
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(Access::session_length).count();
  web::HttpAnswer answer{.status = 204};
  answer.headers.emplace_back(
      "Set-Cookie", fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/socket; Max-Age={}{}", access_->cookie_name(),
                                *cookie, seconds, setup_.abroad ? "; Secure" : ""));
  if (setup_.next_address && !setup_.abroad) setup_.next_address(address());
  return answer;
}

// The cookie is sent to /socket alone. Every page of the session ends.
web::HttpAnswer Console::log_out(const web::HttpRequest& request) {
  if (request.origin.empty()) return plain(403, "only the page may log out");
  const std::optional<std::uint64_t> session = access_->forget(request.cookies);
  for (const auto& [number, page] : pages_) {
    if (page.session == session) page.live->leave();
  }
  return {.status = 204};
}

web::HttpAnswer Console::open_page(const web::HttpRequest& request) {
  if (request.method == "DELETE") return log_out(request);
  const std::optional<Access::Admitted> session = access_->admitted(request.cookies, setup_.executor.now());
  if (std::optional<web::HttpAnswer> why = session ? why_no_page(session->key) : std::nullopt) return std::move(*why);
  if (std::optional<web::HttpAnswer> why = why_no_connection(request, session)) return std::move(*why);
  web::HttpAnswer answer = web_socket_answer(request);
  answer.upgraded = [this, session = *session](web::UpgradedSocket socket) { admit(std::move(socket), session); };
  return answer;
}

std::optional<web::HttpAnswer> Console::why_no_page(const std::string& key) const {
  if (pages_.size() >= max_pages) return plain(503, fmt::format("{} pages are open already: close one", max_pages));
  if (key.empty()) return std::nullopt;
  const auto own = std::ranges::count_if(pages_, [&](const auto& entry) { return entry.second.key == key; });
  if (own < static_cast<std::ptrdiff_t>(max_pages_of_a_key)) return std::nullopt;
  return plain(503, fmt::format("the key {} has {} pages open already: close one", key, max_pages_of_a_key));
}

// The token is a file, which may go or be replaced at any time.
Task<void> Console::end_pages_without_token() {
  while (true) {
    co_await sleep(setup_.executor, between_looks_at_tokens);
    for (const auto& [number, page] : pages_) {
      const bool stands = access_->stands(page.session, setup_.executor.now());
      if (!stands) page.live->dismiss("this session is over: its token is void, or newer sessions took its place");
    }
  }
}

// /socket/N is one more connection of page N, for its images: where that is a page of the same session.
web::HttpAnswer Console::open_lane(const web::HttpRequest& request) {
  const std::optional<Access::Admitted> session = access_->admitted(request.cookies, setup_.executor.now());
  if (std::optional<web::HttpAnswer> why = why_no_connection(request, session)) return std::move(*why);
  const auto page = std::ranges::find_if(pages_, [&](const auto& entry) {
    return request.path.substr(lanes_path.size()) == std::to_string(entry.first) &&
           entry.second.session == session->number;
  });
  if (page == pages_.end()) return plain(404, "there is no such page of this session");
  if (!page->second.live->takes_lane()) return plain(503, "this page has all its connections");
  web::HttpAnswer answer = web_socket_answer(request);
  answer.upgraded = [this, number = page->first](web::UpgradedSocket socket) {
    const auto still = pages_.find(number);
    if (still != pages_.end()) still->second.live->add_lane(std::move(socket));
  };
  return answer;
}

// A program names no origin; a page does, and only those that were named are let in.
web::HttpAnswer Console::open_viewer(const web::HttpRequest& request) {
  const std::vector<std::string>& origins = setup_.foxglove->origins;
  const bool welcome = request.origin.empty() || std::ranges::find(origins, request.origin) != origins.end();
  if (!welcome) return plain(403, "pages of this origin are not let in: name it with --foxglove-origin");
  if (!access_->may_read(request.token)) return plain(403, "the token is wrong: open the address that was printed");
  if (!asks_for_web_socket(request)) return plain(426, "here is a WebSocket alone");
  if (!FoxgloveSession::is_offered(request.web_socket_protocols)) {
    return plain(400, fmt::format("here is {} alone", FoxgloveSession::protocol));
  }
  if (viewers_.size() >= max_viewers) return plain(503, "too many viewers are here");
  web::HttpAnswer answer = web_socket_answer(request);
  answer.headers.emplace_back("Sec-WebSocket-Protocol", FoxgloveSession::protocol);
  answer.upgraded = [this](web::UpgradedSocket socket) { admit_viewer(std::move(socket)); };
  return answer;
}

void Console::admit_viewer(web::UpgradedSocket socket) {
  if (viewers_.size() >= max_viewers) return;
  const int number = next_page_++;
  const std::string name = fmt::format("{}-{}", setup_.name, number);
  Result<std::unique_ptr<Board>> board = setup_.board(name, "");
  if (!board) return;
  const auto ended = [this, number, alive = std::weak_ptr(alive_)] {
    if (!alive.expired()) viewers_.erase(number);
  };
  FoxgloveSession::Setup setup{setup_.executor, setup_.cell.name, std::move(*board), images_, ended};
  viewers_.emplace(number, std::make_unique<FoxgloveSession>(std::move(setup), std::move(socket)));
}

void Console::admit(web::UpgradedSocket socket, const Access::Admitted& session) {
  if (why_no_page(session.key)) return;
  const int number = next_page_++;
  // As a board calls one that comes with that key.
  const std::string prefix = session.key.empty() ? std::string() : session.key + "/";
  const std::string name = fmt::format("{}{}-{}", prefix, setup_.name, number);
  Result<std::unique_ptr<Board>> board = setup_.board(name, session.key);
  // The page sees the connection end, and tries again.
  if (!board) return;
  const auto ended = [this, number, alive = std::weak_ptr(alive_)] {
    if (alive.expired()) return;
    pages_.erase(number);
    if (pages_.empty()) emptied_.set();
  };
  Session::Setup setup{setup_.executor, images_, setup_.cell, number, name, std::move(*board), session.until, ended};
  setup.pictures = setup_.pictures;
  setup.truth = &truth_;
  setup.kept = kept_.get();
  setup.instruments = &setup_.instruments;
  setup.key = session.key;
  setup.page_version = page_.version();
  setup.connect = [this, key = session.key](const std::string& as) { return setup_.board(as, key); };
  pages_.emplace(number,
                 Page{session.number, session.key, std::make_unique<Session>(std::move(setup), std::move(socket))});
}

web::HttpAnswer Console::with_headers(web::HttpAnswer answer) const {
  std::vector<std::string> sockets;
  const std::vector<std::string> loopback{"127.0.0.1", "localhost"};
  for (const std::string& each : setup_.abroad ? setup_.abroad->hosts : loopback) {
    sockets.push_back(fmt::format("{}://{}:{}", setup_.abroad ? "wss" : "ws", each, server_->port()));
  }
  const std::pair<std::string, std::string> headers[] = {
      {"Content-Security-Policy", content_policy(sockets)},
      {"X-Content-Type-Options", "nosniff"},
      {"X-Frame-Options", "DENY"},
      {"Referrer-Policy", "no-referrer"},
      {"Cross-Origin-Opener-Policy", "same-origin"},
      {"Cross-Origin-Resource-Policy", "same-origin"},
      {"Permissions-Policy", "camera=(), microphone=(), geolocation=()"},
      {"Cache-Control", "no-store"}};
  answer.headers.insert(answer.headers.end(), std::begin(headers), std::end(headers));
  return answer;
}

}  // namespace pizarra::console
