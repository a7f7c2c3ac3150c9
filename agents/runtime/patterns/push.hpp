#pragma once

// PUSH: a publisher's news for any number of subscribers, and PULL: one of them on request.
//
//   (pushed TOPIC N DATA)      the newest, numbered from 1, under the publisher's presence
//
//   Publisher news(context, service, "weather");                     // one for a topic
//   co_await news.push(list("rain"_sym));
//   Result<Subscriber> subscriber = co_await Subscriber::to(context, "weather");
//   Result<Push> next = co_await subscriber->next();                 // every one, in order
//   Result<Push> now = co_await pull(context, "weather", deadline);  // the newest, or the first to come
//
// A subscriber that lags behind the board's bound misses some, and sees it by the numbers.

#include "agents/runtime/service.hpp"

namespace pizarra::runtime {

struct Push {
  std::int64_t number = 0;
  Datum data;
};

Relation pushed_relation();

class Publisher {
 public:
  Publisher(AgentContext& context, const Service& service, std::string topic)
      : context_(context), service_(service), topic_(std::move(topic)) {}
  Task<Result<void>> push(Datum data);

 private:
  AgentContext& context_;
  const Service& service_;
  const std::string topic_;
  std::int64_t count_ = 0;
};

class Subscriber {
 public:
  static Task<Result<Subscriber>> to(AgentContext& context, std::string topic);
  // At most one caller at a time.
  Task<Result<Push>> next();

 private:
  explicit Subscriber(std::unique_ptr<Watch> watch) : watch_(std::move(watch)) {}
  std::unique_ptr<Watch> watch_;
  std::vector<Push> waiting_;  // of the last change, the next at the end
};

// Failure timeout.
Task<Result<Push>> pull(AgentContext& context, std::string topic, Time deadline);

}  // namespace pizarra::runtime
