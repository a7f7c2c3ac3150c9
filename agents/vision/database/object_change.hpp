#pragma once

// How what has been learned changes, wherever it is kept.
//
//   ObjectChange change = RenameObject{"circle", "disc"};
//   Result<Transaction> facts = facts_of(change, objects);       // where the board keeps it

#include <optional>
#include <variant>

#include "agents/vision/objects/learned.hpp"
#include "blackboard/board.hpp"

namespace pizarra::vision {

// One more sample of an object, or its first. Its number is the next one.
struct KeepSample {
  std::string name;
  LearnedSample sample;
};
struct WithdrawSample {
  std::string name;
  int number;
  std::int64_t id = 0;  // in a database: what it goes by there, for numbers are given again
};
struct ForgetObject {
  std::string name;
};
struct RenameObject {
  std::string name;
  std::string new_name;
};
using ObjectChange = std::variant<KeepSample, WithdrawSample, ForgetObject, RenameObject>;

// The change as one of the durable facts of the samples (sample_facts.hpp), that are so far as `objects` says. Failures
// `full`, `not-learned` and `name-taken`.
Result<Transaction> facts_of(const ObjectChange& change, const LearnedObjects& objects);

std::unexpected<Failure> name_taken(const std::string& name);

// Every sample as its facts: what to tell, in order.
std::vector<Datum> facts_of(const LearnedObjects& objects);
// Of one object's samples, or, with a number, of that one: what to retract.
std::vector<Datum> patterns_of(const std::string& name, std::optional<int> number = {});

}  // namespace pizarra::vision
