#pragma once

// A learned sample as durable facts. An agent tells each with its own name in front (told_by.hpp):
//
//   (learned NAME NUM AREA PERIMETER FEATURES M0 M1 M2)                                the thesis' Table C.1
//   (learned-template NAME NUM TONE HEIGHT SLIMNESS ROUNDNESS SPREAD SIZE BY TEMPLATE) what recognition needs besides
//   (learned-focal NAME NUM FOCAL)                                                     where it is known
//   (learned-print NAME NUM CONTRAST)                                                  where it is known
//   (learned-axis NAME NUM DEGREES)                                                    of a slim mark, where it is
//   known
//
// TONE is dark, light, or the tag that it is. BY is how its SIZE is known (LearnedSample::SizeBy). Older versions told
// the first two alone, or did not tell the last one or two.
//
//   std::vector<Datum> facts = facts_of_sample("circle", sample);
//   Result<LearnedSample> same = sample_from_facts(facts);

#include "agents/vision/objects/learned.hpp"

namespace pizarra::vision {

// How many arguments a fact of this relation has.
struct SampleRelation {
  std::string_view name;
  std::size_t arguments;
};
// Those of a sample. Of every sample there is one fact of each of the first two.
inline constexpr std::array<SampleRelation, 5> sample_relations = {
    {{"learned", 8}, {"learned-template", 10}, {"learned-focal", 3}, {"learned-print", 3}, {"learned-axis", 3}}};

Datum learned_fact(const std::string& name, const LearnedSample& sample);
Datum learned_template_fact(const std::string& name, const LearnedSample& sample);
Datum learned_focal_fact(const std::string& name, const LearnedSample& sample);
Datum learned_print_fact(const std::string& name, const LearnedSample& sample);
Datum learned_axis_fact(const std::string& name, const LearnedSample& sample);

std::vector<Datum> facts_of_sample(const std::string& name, const LearnedSample& sample);
// `facts`: all of one sample, in any order. Failures `damaged` and `bad-template`.
Result<LearnedSample> sample_from_facts(const std::vector<Datum>& facts);

}  // namespace pizarra::vision
