#pragma once

// A relation is declared once: the name of its facts, the names and types of their arguments, the key arguments,
// whether the facts are durable, and for how long a told fact stays without being told again.
//
//   (relation seen ((name string) (x number) (y number)) (key name))            ; told again, the old sighting goes
//   (relation on ((upper symbol) (lower symbol)))                               ; no key given: every argument is key
//   (relation said ((frame integer) (text string)) (key))                       ; an empty key: one fact at most
//   (relation goal ((n integer) (facts datum)) (key n) (durable))
//   (relation alarm ((text string)) (lease 5000))                               ; milliseconds

#include <optional>
#include <string>
#include <vector>

#include "blackboard/time/clock.hpp"
#include "lisp/result.hpp"

namespace pizarra {

enum class ArgumentType : std::uint8_t { symbol, string, integer, number, list, datum };

struct Argument {
  std::string name;
  ArgumentType type;
  bool operator==(const Argument&) const = default;
};

struct Relation {
  std::string name;
  std::vector<Argument> arguments;
  std::vector<std::size_t> key;  // positions in `arguments`
  bool durable = false;
  std::optional<Duration> lease;
  bool operator==(const Relation&) const = default;
};

Result<Relation> relation_from_datum(const Datum& form);
Datum relation_to_datum(const Relation& relation);

// Whether `fact` has the relation's name, number and types of arguments and no variable in it: an integer is a number.
Result<void> check_shape(const Relation& relation, const Datum& fact);
// The same for a pattern, whose arguments may be or hold variables.
Result<void> check_pattern_shape(const Relation& relation, const Datum& pattern);
bool fits_type(ArgumentType type, const Datum& value);
// The fact's key: relation name and key arguments.
Datum key_of(const Relation& relation, const Datum& fact);

}  // namespace pizarra
