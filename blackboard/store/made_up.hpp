#pragma once

// Answers from facts of one relation that nobody tells: they are made up when somebody asks for them.
//
//   if (asks_for(query, about.name)) answers = answer_from(about, std::move(forms), query, asked, examined);

#include <string_view>
#include <vector>

#include "blackboard/query.hpp"
#include "blackboard/relation.hpp"

namespace pizarra::store {

// Whether one of its patterns does.
bool asks_for(const Query& query, std::string_view relation);

struct AskedAt {
  Revision revision = 0;
  Time when{};
};

// Adds to `examined` how many of these facts it looked at. Failures wrong-shape, too-costly, and bad-query where other
// relations are asked for too.
Result<Answers> answer_from(const Relation& about, std::vector<Datum> forms, const Query& query, const AskedAt& asked,
                            std::size_t& examined);

}  // namespace pizarra::store
