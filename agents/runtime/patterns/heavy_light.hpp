#pragma once

// HEAVY-LIGHT: one frame for several servers, and a short answer from each: the frame goes over an image stream, once
// however many they are, and the answers over the board.
//
//   (ready-for STREAM SERVER)                   a server listens, under its presence
//   (light-answer STREAM FRAME SERVER VALUE)    for ten seconds
//
//   HeavyServer server(context, service, streams, "scene", work);      // work: StreamFrame -> Task<Datum>
//   co_await server.serve();
//   HeavyAsker asker(context, service, streams, "scene");
//   co_await asker.announce();
//   Result<std::vector<LightAnswer>> answers = co_await asker.ask(frame, 2s);
//
// Frame numbers are the asker's, each used once.

#include <functional>

#include "agents/runtime/service.hpp"
#include "blackboard/stream.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::runtime {

struct LightAnswer {
  std::string server;
  Datum value;
  bool operator==(const LightAnswer&) const = default;
};

std::vector<Relation> heavy_light_relations();

class HeavyServer {
 public:
  using Work = std::function<Task<Datum>(StreamFrame frame)>;

  // All but the last two outlive it. The service has started.
  HeavyServer(AgentContext& context, const Service& service, Streams& streams, std::string stream, Work work);
  // Answers every frame it sees, the newest first, until destroyed.
  Task<Result<void>> serve();

 private:
  Task<Result<void>> say_ready();
  Task<Result<void>> answer(StreamFrame frame);

  AgentContext& context_;
  const Service& service_;
  Streams& streams_;
  const std::string stream_;
  Work work_;
  std::optional<StreamFrame> newest_;
  Event come_;
};

class HeavyAsker {
 public:
  HeavyAsker(AgentContext& context, const Service& service, Streams& streams, std::string stream);
  // Says where the stream is, so that servers are there before the first frame.
  Task<Result<void>> announce();
  // The answers of those that were ready when it was asked, by server; without those that did not answer in time.
  Task<Result<std::vector<LightAnswer>>> ask(StreamFrame frame, Duration patience);

 private:
  Task<Result<Answer>> await_one(StreamFrame frame, Datum server, Time deadline);

  AgentContext& context_;
  const Service& service_;
  Streams& streams_;
  const std::string stream_;
};

}  // namespace pizarra::runtime
