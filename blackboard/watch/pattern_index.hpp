#pragma once

// The patterns of watched queries about one relation, by what facts can fit them: a changed fact leads to few others.
//
// Each is filed under one of its arguments that has to have a value, by a constant or by (= ?x VALUE), the one that the
// fewest others are filed under; those without any are filed together. Watches filed together are ordered by one end of
// the range that comparisons with numbers leave for an argument, where there is such a range: a fact leads to the ends
// it is beyond.
//
// Joins are not used to narrow: every fact of (reading ?s ?v) leads to each (and (role 7 ?s) (reading ?s ?v)), also
// while there is no such role.
//
//   index.add(pattern);                                                    // lives on until it is removed
//   index.visit(fact, [&](const WatchedPattern& p) { if (p.may_fit(fact)) ... });
//   index.remove(pattern);

#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "blackboard/query.hpp"
#include "blackboard/store/compare_values.hpp"
#include "blackboard/store/ordered_index.hpp"

namespace pizarra::watch {

class WatchQueue;

struct WatchedPattern {
  WatchQueue* watch;
  Datum pattern;
  std::vector<store::ValueRange> ranges;  // where the query's comparisons leave its arguments
  std::size_t place = 0;                  // of the argument that it is filed under

  // No fact that an answer needs, or that blocks one, is refused.
  bool may_fit(const Datum& fact) const;
};

std::vector<WatchedPattern> patterns_of(const Query& query, WatchQueue* watch);

class PatternIndex {
 public:
  // It has not been added anywhere.
  void add(WatchedPattern& pattern);
  void remove(const WatchedPattern& pattern);
  // Calls for every pattern that may be fitted by the fact, and few others.
  template <class Visitor>
  void visit(const Datum& fact, Visitor&& visitor) const {
    together_.visit(fact, visitor);
    for (const auto& [place, files] : by_argument_) {
      const auto file = files.find(by_value(fact[place]));
      if (file != files.end()) file->second.visit(fact, visitor);
    }
  }
  template <class Visitor>
  void visit_all(Visitor&& visitor) const {
    together_.visit_all(visitor);
    for (const auto& [place, files] : by_argument_) {
      for (const auto& [value, file] : files) file.visit_all(visitor);
    }
  }

 private:
  using Patterns = std::vector<const WatchedPattern*>;
  struct Before {
    bool operator()(const Datum& a, const Datum& b) const { return store::compare_values(a, b) < 0; }
  };
  using ByEnd = std::map<Datum, Patterns, Before>;
  struct Ends {
    ByEnd from;
    ByEnd to;
  };

  class File {
   public:
    void add(const WatchedPattern& pattern);
    void remove(const WatchedPattern& pattern);
    std::size_t size() const { return size_; }
    template <class Visitor>
    void visit(const Datum& fact, Visitor&& visitor) const {
      for (const WatchedPattern* pattern : unordered_) visitor(*pattern);
      for (const auto& [argument, ends] : by_range_) {
        const Datum& value = fact[argument + 1];
        visit(ends.from.begin(), ends.from.upper_bound(value), visitor);
        visit(ends.to.lower_bound(value), ends.to.end(), visitor);
      }
    }
    template <class Visitor>
    void visit_all(Visitor&& visitor) const {
      for (const WatchedPattern* pattern : unordered_) visitor(*pattern);
      for (const auto& [argument, ends] : by_range_) {
        visit(ends.from.begin(), ends.from.end(), visitor);
        visit(ends.to.begin(), ends.to.end(), visitor);
      }
    }

   private:
    template <class Visitor>
    static void visit(ByEnd::const_iterator begin, ByEnd::const_iterator end, Visitor&& visitor) {
      for (; begin != end; ++begin) {
        for (const WatchedPattern* pattern : begin->second) visitor(*pattern);
      }
    }

    std::size_t size_ = 0;
    Patterns unordered_;
    std::map<std::size_t, Ends> by_range_;  // of an argument
  };
  using Files = std::unordered_map<Datum, File>;

  // The same for numbers of the same value.
  static Datum by_value(const Datum& value);
  // The value that the argument must have, if that is known.
  static std::optional<Datum> value_at(std::size_t place, const WatchedPattern& pattern);
  std::size_t size_of_file(std::size_t place, const Datum& value) const;

  File together_;
  std::map<std::size_t, Files> by_argument_;  // by its place in the fact
};

}  // namespace pizarra::watch
