#pragma once

// One viewer of the Foxglove WebSocket protocol (foxglove.websocket.v1): it is told which channels there are
// (foxglove_channels.hpp), subscribes to some, and gets what holds and every change. It reads, and can do nothing else:
// whatever else it asks for is refused in words.
//
//   FoxgloveSession viewer({executor, "blocks", std::move(board), images, [] { ... }}, std::move(socket));
//
// A viewer has 32 subscriptions at most. One that takes nothing has its changes wait on the board, which tells it all
// that holds when too much does; after 30 s it is let go. Images that it does not take in time are left out.

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agents/console/image_feed.hpp"
#include "blackboard/board.hpp"
#include "blackboard/time/latch.hpp"
#include "drivers/web/web_socket.hpp"

namespace pizarra::console {

class FoxgloveSession {
 public:
  static constexpr std::string_view protocol = "foxglove.websocket.v1";
  static constexpr std::size_t max_subscriptions = 32;
  // Whether a Sec-WebSocket-Protocol header names it.
  static bool is_offered(std::string_view protocols);

  struct Setup {
    Executor& executor;
    std::string cell;
    std::unique_ptr<Board> board;
    ImageFeeds& images;           // outlives the viewer
    std::function<void()> ended;  // this may be destroyed
  };

  FoxgloveSession(Setup setup, web::UpgradedSocket socket);
  FoxgloveSession(const FoxgloveSession&) = delete;
  FoxgloveSession& operator=(const FoxgloveSession&) = delete;
  ~FoxgloveSession();

 private:
  using Standing = std::map<FactId, Fact>;
  struct Numbers {
    std::uint32_t subscription;
    std::size_t channel;
  };

  void hear(std::string_view message);
  void subscribe(const nlohmann::json& subscriptions);
  // What is wrong with it.
  std::optional<std::string_view> subscribe(std::optional<std::uint32_t> subscription,
                                            std::optional<std::uint32_t> channel);
  void say(std::string text);
  void refuse(std::string_view sentence);
  void send(const Numbers& numbers, Time when, std::string_view json);
  void tell(const Numbers& numbers, const Change& change, Standing& standing);
  Task<void> follow(Numbers numbers, Query query);
  Task<void> follow_images(Numbers numbers);
  std::unique_ptr<ImageFeeds::Look> look(const Numbers& numbers, const std::string& stream);
  Task<void> room();

  Setup setup_;
  Event room_;
  std::unique_ptr<web::WebSocket> socket_;
  std::map<std::uint32_t, std::vector<Job>> subscriptions_;
};

}  // namespace pizarra::console
