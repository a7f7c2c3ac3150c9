#include "agents/console/foxglove_session.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "agents/console/foxglove_channels.hpp"
#include "agents/runtime/declared.hpp"
#include "lisp/json.hpp"
#include "lisp/reader.hpp"

namespace pizarra::console {

namespace {

using nlohmann::json;

std::string advertisement() {
  std::vector<FoxgloveChannel> offered(foxglove_channels().begin(), foxglove_channels().end());
  for (const FoxgloveImages& images : foxglove_images()) offered.push_back(images.channel);
  std::string items;
  std::size_t number = 0;
  for (const FoxgloveChannel& channel : offered) {
    items += fmt::format(
        R"({}{{"id":{},"topic":{},"encoding":"json","schemaName":{},"schema":{},"schemaEncoding":"jsonschema"}})",
        number == 0 ? "" : ",", number, json_string(channel.topic), json_string(channel.schema_name),
        json_string(channel.schema));
    ++number;
  }
  return fmt::format(R"({{"op":"advertise","channels":[{}]}})", items);
}

// A number of 32 bits, which is what all numbers of the protocol are.
std::optional<std::uint32_t> number_in(const json& value) {
  if (!value.is_number_unsigned()) return std::nullopt;
  const auto number = value.get<std::uint64_t>();
  if (number > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return static_cast<std::uint32_t>(number);
}

std::optional<std::uint32_t> number_in(const json& object, const char* name) {
  return object.is_object() && object.contains(name) ? number_in(object[name]) : std::nullopt;
}

// The elements of a list in a JSON object; none where there is no such list.
json list_in(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_array() ? *found : json::array();
}

// The name of the stream whose kind comes first; none where none is of these kinds.
std::string best_stream(const std::map<FactId, Fact>& streams, std::span<const std::string_view> kinds) {
  for (const std::string_view kind : kinds) {
    const auto is_of_kind = [kind](const auto& entry) { return entry.second.datum[2].text() == kind; };
    const auto found = std::ranges::find_if(streams, is_of_kind);
    if (found != streams.end()) return std::string(found->second.datum[1].text());
  }
  return {};
}

template <class Number>
void append_little_endian(std::string& bytes, Number number) {
  for (std::size_t i = 0; i < sizeof number; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
}

}  // namespace

bool FoxgloveSession::is_offered(std::string_view protocols) {
  while (!protocols.empty()) {
    const std::size_t end = std::min(protocols.find(','), protocols.size());
    std::string_view offered = protocols.substr(0, end);
    while (offered.starts_with(' ')) offered.remove_prefix(1);
    while (offered.ends_with(' ')) offered.remove_suffix(1);
    if (offered == protocol) return true;
    protocols.remove_prefix(std::min(end + 1, protocols.size()));
  }
  return false;
}

FoxgloveSession::FoxgloveSession(Setup setup, web::UpgradedSocket socket)
    : setup_(std::move(setup)), room_(setup_.executor) {
  web::WebSocket::Events events{.text = [this](std::string_view message) { hear(message); },
                                .room = [this] { room_.set(); },
                                .ended = setup_.ended};
  socket_ = std::make_unique<web::WebSocket>(setup_.executor, std::move(socket), std::move(events));
  say(fmt::format(R"({{"op":"serverInfo","name":{},"capabilities":[],"supportedEncodings":[],"metadata":{{}}}})",
                  json_string("Pizarra " + setup_.cell)));
  say(advertisement());
}

FoxgloveSession::~FoxgloveSession() = default;

void FoxgloveSession::say(std::string text) { socket_->send(web::WebSocket::Class::control, std::move(text)); }

void FoxgloveSession::refuse(std::string_view sentence) {
  constexpr int error = 2;
  say(fmt::format(R"({{"op":"status","level":{},"message":{}}})", error, json_string(sentence)));
}

void FoxgloveSession::hear(std::string_view message) {
  const json said = json::parse(message, nullptr, false);
  const bool readable = said.is_object() && said.contains("op") && said["op"].is_string();
  if (!readable) return refuse("this is no operation of foxglove.websocket.v1");
  if (said["op"] == "subscribe") {
    subscribe(list_in(said, "subscriptions"));
  } else if (said["op"] == "unsubscribe") {
    for (const json& number : list_in(said, "subscriptionIds")) {
      if (const auto subscription = number_in(number)) subscriptions_.erase(*subscription);
    }
  } else {
    refuse("a viewer subscribes and unsubscribes here, and nothing else: this console lets it read alone");
  }
}

// One refusal a message: a viewer that asks for a thousand is not answered a thousand times.
void FoxgloveSession::subscribe(const json& subscriptions) {
  std::optional<std::string_view> refused;
  if (subscriptions.size() > max_subscriptions) refused = "there are too many subscriptions in one message";
  if (!refused) {
    for (const json& wanted : subscriptions) {
      const auto why = subscribe(number_in(wanted, "id"), number_in(wanted, "channelId"));
      if (!refused) refused = why;
    }
  }
  if (refused) refuse(*refused);
}

std::optional<std::string_view> FoxgloveSession::subscribe(std::optional<std::uint32_t> subscription,
                                                           std::optional<std::uint32_t> channel) {
  if (!subscription) return "a subscription needs an id: a whole number of 32 bits";
  const std::size_t of_facts = foxglove_channels().size();
  if (!channel || *channel >= of_facts + foxglove_images().size()) return "there is no such channel";
  // One whose watch failed may be asked for again.
  std::erase_if(subscriptions_, [](const auto& entry) { return std::ranges::all_of(entry.second, &Job::done); });
  const Numbers numbers{*subscription, *channel};
  if (subscriptions_.contains(numbers.subscription)) return "there is a subscription of this id already";
  if (subscriptions_.size() >= max_subscriptions) return "there are too many subscriptions";
  std::vector<Job>& jobs = subscriptions_[numbers.subscription];
  if (numbers.channel >= of_facts) {
    jobs.push_back(setup_.executor.spawn(follow_images(numbers)));
    return std::nullopt;
  }
  for (const std::string_view pattern : foxglove_patterns(numbers.channel)) {
    jobs.push_back(setup_.executor.spawn(follow(numbers, query_for(read_one(pattern).value()))));
  }
  return std::nullopt;
}

Task<void> FoxgloveSession::follow(Numbers numbers, Query query) {
  const Result<std::unique_ptr<Watch>> watch = co_await runtime::watch_when_declared(*setup_.board, std::move(query));
  if (!watch) {
    refuse(watch.error().sentence);
    co_return;
  }
  Standing standing;
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) {
      refuse(change.error().sentence);
      co_return;
    }
    co_await room();
    tell(numbers, *change, standing);
  }
}

// A look follows its stream from one publisher to the next. Of several streams the one of the best kind is shown, as
// long as it stands.
Task<void> FoxgloveSession::follow_images(Numbers numbers) {
  Query streams = query_for(list("stream"_sym, "?name"_sym, "?kind"_sym, "?place"_sym));
  const Result<std::unique_ptr<Watch>> watch = co_await runtime::watch_when_declared(*setup_.board, std::move(streams));
  if (!watch) {
    refuse(watch.error().sentence);
    co_return;
  }
  const std::span<const std::string_view> kinds = foxglove_images()[numbers.channel - foxglove_channels().size()].kinds;
  Standing standing;
  std::string shown;
  std::unique_ptr<ImageFeeds::Look> looking;
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) {
      refuse(change.error().sentence);
      co_return;
    }
    if (change->resynchronised) standing.clear();
    for (const Answer& answer : change->removed) standing.erase(answer.facts.front().id);
    for (const Answer& answer : change->added) standing.emplace(answer.facts.front().id, answer.facts.front());
    const std::string best = best_stream(standing, kinds);
    if (best == shown) continue;
    shown = best;
    looking.reset();
    if (!best.empty()) looking = look(numbers, best);
  }
}

std::unique_ptr<ImageFeeds::Look> FoxgloveSession::look(const Numbers& numbers, const std::string& stream) {
  auto look = setup_.images.look(stream, [this, numbers](const std::shared_ptr<const ImageFeeds::Picture>& picture) {
    const bool taken_in = socket_->waiting() < web::WebSocket::low_mark;
    if (taken_in) send(numbers, picture->captured, foxglove_image(picture->captured, picture->jpeg));
  });
  look->want(ImageFeeds::Size::full);
  return look;
}

Task<void> FoxgloveSession::room() {
  while (socket_->waiting() >= web::WebSocket::low_mark) {
    room_.reset();
    co_await room_.wait();
  }
}

// After a resynchronisation what stands no more is gone, and what stood before is no news.
void FoxgloveSession::tell(const Numbers& numbers, const Change& change, Standing& standing) {
  const Time now = setup_.executor.now();
  Standing gone;
  if (change.resynchronised) gone.swap(standing);
  for (const Answer& answer : change.added) {
    const Fact& fact = answer.facts.front();
    if (auto known = gone.extract(fact.id)) standing.insert(std::move(known));
  }
  for (const Answer& answer : change.removed) {
    if (auto known = standing.extract(answer.facts.front().id)) gone.insert(std::move(known));
  }
  for (const auto& [id, fact] : gone) {
    for (const FoxgloveMessage& message : foxglove_messages_of_gone(fact, now)) {
      if (message.channel == numbers.channel) send(numbers, now, message.json);
    }
  }
  for (const Answer& answer : change.added) {
    const Fact& fact = answer.facts.front();
    if (!standing.emplace(fact.id, fact).second) continue;
    for (const FoxgloveMessage& message : foxglove_messages(fact)) {
      if (message.channel == numbers.channel) send(numbers, fact.when, message.json);
    }
  }
}

// Message data: 1, the subscription's number, the time in nanoseconds, both little endian, and the message.
void FoxgloveSession::send(const Numbers& numbers, Time when, std::string_view message) {
  std::string bytes(1, '\1');
  append_little_endian(bytes, numbers.subscription);
  append_little_endian(bytes, static_cast<std::uint64_t>(when.time_since_epoch().count()) * 1000);
  socket_->send(web::WebSocket::Class::images, bytes.append(message));
}

}  // namespace pizarra::console
