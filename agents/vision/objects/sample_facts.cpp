#include "agents/vision/objects/sample_facts.hpp"

#include <algorithm>

#include "lisp/numbers.hpp"

namespace pizarra::vision {
namespace {

// Null where none of them is of this relation.
const Datum* fact_of(const std::vector<Datum>& facts, const SampleRelation& relation) {
  const auto found = std::ranges::find_if(
      facts, [&](const Datum& fact) { return fact.is_form(relation.name) && fact.size() == relation.arguments + 1; });
  return found == facts.end() ? nullptr : &*found;
}

}  // namespace

Datum learned_fact(const std::string& name, const LearnedSample& sample) {
  return list("learned"_sym, name, sample.number, rounded(sample.area_px, 1000), sample.perimeter_px, sample.corners,
              rounded(sample.moments[0], 1000), rounded(sample.moments[1], 1000), rounded(sample.moments[2], 1000));
}

Datum learned_template_fact(const std::string& name, const LearnedSample& sample) {
  return list("learned-template"_sym, name, sample.number, Datum::symbol(tone_of(sample)), sample.height_px,
              sample.slimness, sample.roundness, sample.roundness_spread, sample.size_mm,
              Datum::symbol(std::string(size_by_of(sample))), template_to_text(sample.picture));
}

Datum learned_focal_fact(const std::string& name, const LearnedSample& sample) {
  return list("learned-focal"_sym, name, sample.number, sample.focal_px);
}

Datum learned_print_fact(const std::string& name, const LearnedSample& sample) {
  return list("learned-print"_sym, name, sample.number, sample.contrast);
}

Datum learned_axis_fact(const std::string& name, const LearnedSample& sample) {
  return list("learned-axis"_sym, name, sample.number, sample.axis_deg);
}

std::vector<Datum> facts_of_sample(const std::string& name, const LearnedSample& sample) {
  std::vector<Datum> out = {learned_fact(name, sample), learned_template_fact(name, sample)};
  if (sample.focal_px > 0) out.push_back(learned_focal_fact(name, sample));
  if (sample.contrast > 0) out.push_back(learned_print_fact(name, sample));
  if (sample.axis_deg > 0) out.push_back(learned_axis_fact(name, sample));
  return out;
}

Result<LearnedSample> sample_from_facts(const std::vector<Datum>& facts) {
  const Datum* learned = fact_of(facts, sample_relations[0]);
  const Datum* learned_template = fact_of(facts, sample_relations[1]);
  if (learned == nullptr || learned_template == nullptr) {
    return fail("damaged", "its fact `learned` or `learned-template` is missing");
  }
  Result<MarkTemplate> picture = template_from_text((*learned_template)[10].text());
  if (!picture) return fail(picture);
  LearnedSample out;
  out.number = static_cast<int>((*learned)[2].number());
  out.area_px = (*learned)[3].number();
  out.perimeter_px = static_cast<int>((*learned)[4].number());
  out.corners = static_cast<int>((*learned)[5].number());
  out.moments = {(*learned)[6].number(), (*learned)[7].number(), (*learned)[8].number()};
  set_tone(out, (*learned_template)[3].text());
  out.height_px = (*learned_template)[4].number();
  out.slimness = (*learned_template)[5].number();
  out.roundness = (*learned_template)[6].number();
  out.roundness_spread = (*learned_template)[7].number();
  out.size_mm = (*learned_template)[8].number();
  set_size_by(out, (*learned_template)[9].text());
  const Datum* focal = fact_of(facts, sample_relations[2]);
  if (focal != nullptr) out.focal_px = (*focal)[3].number();
  const Datum* print = fact_of(facts, sample_relations[3]);
  if (print != nullptr) out.contrast = (*print)[3].number();
  const Datum* axis = fact_of(facts, sample_relations[4]);
  if (axis != nullptr) out.axis_deg = (*axis)[3].number();
  out.set_picture(*picture);
  return out;
}

}  // namespace pizarra::vision
