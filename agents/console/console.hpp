#pragma once

// The console: the cell in a browser. A server on loopback, or elsewhere with TLS, gives the page to anyone who asks
// for it by the right name. It shows the board only to a browser that has exchanged a token for a cookie (access.hpp).
// Each page has a board session of its own (session.hpp).
//
//   Result<std::unique_ptr<Console>> console = Console::open({.executor = executor, .streams = streams, ...});
//   print((*console)->address());                  // http://127.0.0.1:40213/#TOKEN
//   co_await (*console)->close();                  // every page has left the board
//
// Where the setup says so it also speaks the Foxglove WebSocket protocol at /foxglove (foxglove_session.hpp): to
// programs, and to browsers' pages of the origins that are named, that show the reading token.
//
// At most `max_pages` pages are open at once, `max_pages_of_a_key` of one key, and `max_viewers` viewers.
// A page ends within two seconds when its token is removed or made anew.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/console/access.hpp"
#include "agents/console/foxglove_session.hpp"
#include "agents/console/page_files.hpp"
#include "agents/console/picture_keeper.hpp"
#include "agents/console/session.hpp"
#include "agents/console/wiring.hpp"
#include "drivers/web/http_server.hpp"

namespace pizarra::console {

class Console {
 public:
  static constexpr std::size_t max_pages = 16;
  static constexpr std::size_t max_pages_of_a_key = 8;
  static constexpr std::size_t max_viewers = 8;

  // A session with the board under a name of its own, as the key of that name may; no key's name: the console's own.
  using BoardMaker = std::function<Result<std::unique_ptr<Board>>(const std::string& name, const std::string& key)>;

  // For browsers of other machines: by TLS alone, with the token of a key.
  struct Abroad {
    std::string address;             // to listen at
    std::vector<std::string> hosts;  // by which browsers may call it; the first is printed
    std::string certificate;         // both as PEM
    std::string certificate_key;
    std::string tokens;  // the folder of keys and their tokens (blackboard/wire/tokens.hpp)
  };
  struct Foxglove {
    std::vector<std::string> origins;  // https://app.foxglove.dev
  };

  // Executor and streams outlive the console.
  struct Setup {
    Executor& executor;
    Streams& streams;
    BoardMaker board;
    CellView cell;
    std::string name;         // pages are called NAME-1, NAME-2 ... on the board
    std::string page_folder;  // of what page/build.mjs made
    int port = 0;
    std::string journal = {};  // of the board, a file that can be read here; empty: there is none
    std::optional<Abroad> abroad = std::nullopt;
    std::function<void(const std::string& address)> next_address = nullptr;  // the last one has been used
    std::optional<Foxglove> foxglove = std::nullopt;
    PictureStore* pictures = nullptr;                       // what the eyes see is kept there; it outlives the console
    std::function<void(const Failure&)> trouble = nullptr;  // pictures are not kept
    TruthFeed::Ask truth = nullptr;                         // of a simulated cell
    Instruments instruments = {};
  };

  // Failures: unreadable-file, cannot-listen, those of a board that refuses this console.
  static Result<std::unique_ptr<Console>> open(Setup setup);
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;
  ~Console();

  // Where one browser may come.
  std::string address() const;
  // For Foxglove, its token included.
  std::string foxglove_address() const;
  std::size_t pages() const { return pages_.size(); }
  std::size_t viewers() const { return viewers_.size(); }
  Task<void> close();

 private:
  Console(Setup setup, PageFiles page);
  Result<void> keep_pictures();
  Result<void> keep_changes();
  Result<void> tell_wiring();
  web::HttpAnswer answer(const web::HttpRequest& request);
  web::HttpAnswer exchange(const web::HttpRequest& request);
  web::HttpAnswer open_page(const web::HttpRequest& request);
  web::HttpAnswer open_lane(const web::HttpRequest& request);
  web::HttpAnswer open_viewer(const web::HttpRequest& request);
  web::HttpAnswer log_out(const web::HttpRequest& request);
  // Nothing: one more page of that key may be opened.
  std::optional<web::HttpAnswer> why_no_page(const std::string& key) const;
  Task<void> end_pages_without_token();
  std::string host() const;
  void admit(web::UpgradedSocket socket, const Access::Admitted& session);
  void admit_viewer(web::UpgradedSocket socket);
  web::HttpAnswer with_headers(web::HttpAnswer answer) const;

  Setup setup_;
  PageFiles page_;
  ImageFeeds images_;
  TruthFeed truth_;
  std::unique_ptr<PictureKeeper> keeper_;
  std::unique_ptr<KeptChanges> kept_;
  std::unique_ptr<Wiring> wiring_;
  std::unique_ptr<web::HttpServer> server_;
  std::unique_ptr<Access> access_;
  int next_page_ = 1;
  Event emptied_;
  std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);  // whoever may outlast this looks
  struct Page {
    std::uint64_t session;  // of those that were admitted
    std::string key;        // whose it is
    std::unique_ptr<Session> live;
  };
  std::map<int, Page> pages_;
  std::map<int, std::unique_ptr<FoxgloveSession>> viewers_;
  Job ending_;  // pages whose token was taken away
};

}  // namespace pizarra::console
