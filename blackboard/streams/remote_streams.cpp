#include "blackboard/streams/remote_streams.hpp"

#include "blackboard/streams/stream_guest.hpp"

namespace pizarra::streams {

namespace {

// What a board refuses it refuses again, and counts.
constexpr Duration longest_pause = 30s;

}  // namespace

// A subscription that follows where its stream is published.
class RemoteStreams::Following : public Streams::Subscription {
 public:
  Following(RemoteStreams& streams, std::string stream, Receiver receiver)
      : executor_(streams.executor_),
        board_(streams.board_),
        context_(streams.context_),
        stream_(std::move(stream)),
        receiver_(std::move(receiver)) {
    job_ = executor_.spawn(follow());
  }
  Following(const Following&) = delete;
  Following& operator=(const Following&) = delete;
  ~Following() override {
    if (retry_ != 0) executor_.cancel(retry_);
  }
  std::optional<Failure> trouble() const override { return trouble_; }

 private:
  Task<void> follow();
  Task<Result<std::unique_ptr<Watch>>> watch();
  void announced(const Change& change);
  void connect();
  void try_again();

  Executor& executor_;
  Board& board_;
  zmq::context_t& context_;
  const std::string stream_;
  Receiver receiver_;
  Datum place_;
  std::optional<Failure> trouble_;
  std::unique_ptr<Subscription> connection_;
  Executor::TimerId retry_ = 0;
  Job job_;
};

Task<Result<std::unique_ptr<Watch>>> RemoteStreams::Following::watch() {
  const std::vector<Relation> relations{stream_relation()};
  const Result<void> declared = co_await board_.declare(relations);
  if (!declared) co_return fail(declared);
  const Query query = query_for(list("stream"_sym, Datum::symbol(stream_), "?kind"_sym, "?place"_sym));
  co_return co_await board_.watch(query);
}

Task<void> RemoteStreams::Following::follow() {
  Duration pause = retry_pause;
  while (true) {
    const Result<std::unique_ptr<Watch>> watching = co_await watch();
    bool going_on = watching.has_value();
    if (!going_on) trouble_ = watching.error();
    while (going_on) {
      const Result<Change> change = co_await (*watching)->next();
      going_on = change.has_value();
      if (!going_on) trouble_ = change.error();
      if (!going_on) continue;
      announced(*change);
      trouble_.reset();
      pause = retry_pause;
    }
    co_await sleep(executor_, pause);
    pause = std::min(2 * pause, longest_pause);
  }
}

// A stream that is not announced any more may well go on: its publisher's presence lapsed with the board.
void RemoteStreams::Following::announced(const Change& change) {
  if (change.added.empty()) return;
  constexpr std::size_t place = 3;
  const Datum now = change.added.back().facts.front().datum[place];
  if (connection_ && now == place_) return;
  place_ = now;
  connect();
}

// The memory of this machine where the publisher is on it, else the network.
void RemoteStreams::Following::connect() {
  connection_.reset();
  for (const Datum& way : place_.items()) {
    if (way.is_form("door") && way.size() == 2) {
      auto guest = StreamGuest::come(executor_, std::string(way[1].text()), stream_, receiver_, [this] {
        connection_.reset();
        try_again();
      });
      if (guest) connection_ = std::move(*guest);
    } else {
      auto listener = StreamListener::come(executor_, context_, way, stream_, receiver_);
      if (listener) connection_ = std::move(*listener);
    }
    if (connection_) return;
  }
  try_again();
}

void RemoteStreams::Following::try_again() {
  if (retry_ != 0) return;
  retry_ = executor_.call_at(executor_.now() + retry_pause, [this] {
    retry_ = 0;
    if (!connection_) connect();
  });
}

Result<std::unique_ptr<RemoteStreams>> RemoteStreams::open(Executor& executor, Board& board,
                                                           const std::string& listen_address) {
  Result<std::unique_ptr<StreamDoor>> door = StreamDoor::open(executor);
  if (!door) return fail(door);
  std::unique_ptr<StreamBroadcast> broadcast;
  if (!listen_address.empty()) {
    Result<std::unique_ptr<StreamBroadcast>> opened = StreamBroadcast::open(executor, listen_address);
    if (!opened) return fail(opened);
    broadcast = std::move(*opened);
  }
  return std::unique_ptr<RemoteStreams>(new RemoteStreams(executor, board, std::move(*door), std::move(broadcast)));
}

RemoteStreams::RemoteStreams(Executor& executor, Board& board, std::unique_ptr<StreamDoor> door,
                             std::unique_ptr<StreamBroadcast> broadcast)
    : executor_(executor), board_(board), door_(std::move(door)), broadcast_(std::move(broadcast)) {}

Datum RemoteStreams::place() const {
  const Datum door = list("door"_sym, door_->name());
  return broadcast_ ? list(door, broadcast_->ticket()) : list(door);
}

bool RemoteStreams::watched(const std::string& stream) const {
  return door_->watched(stream) || (broadcast_ && broadcast_->watched(stream));
}

void RemoteStreams::publish(const std::string& stream, const StreamFrame& frame) {
  door_->publish(stream, frame);
  if (broadcast_) broadcast_->publish(stream, frame);
}

std::unique_ptr<Streams::Subscription> RemoteStreams::subscribe(const std::string& stream, Receiver receiver) {
  return std::make_unique<Following>(*this, stream, std::move(receiver));
}

}  // namespace pizarra::streams
