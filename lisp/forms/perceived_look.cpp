#include "lisp/forms/perceived_look.hpp"

#include "lisp/forms/vision_reply.hpp"
#include "lisp/guile/scheme.hpp"

namespace pizarra::forms {

namespace {

SeenObject seen_object(const Datum& seen) {
  SeenObject out{std::string(seen[0].text()), {seen[1].number(), seen[2].number(), seen[3].number()}, std::nullopt};
  if (seen.size() > 4) out.face_deg = seen[4].number();
  return out;
}

}  // namespace

Result<PerceivedLook> perceive_look(const Perception& perception, std::string_view text, const Datum& of,
                                    const LookSituation& situation, const std::vector<Datum>& believed) {
  const Result<Source> source = read_vision_reply(text);
  if (!source) return fail(source);
  const Datum situated =
      list(situation.camera, situation.hand, Datum::list(situation.remembered), Datum::list(situation.measured));
  const Result<Datum> look =
      guile::interpret(*source, "looks", {of, situated, perception.section(), Datum::list(believed)});
  if (!look) return fail(look);
  PerceivedLook out;
  for (const Datum& seen : (*look)[0].items()) out.seen.push_back(seen_object(seen));
  for (const Datum& name : (*look)[1].items()) out.hidden.emplace_back(name.text());
  out.facts = found_facts((*look)[2]);
  return out;
}

}  // namespace pizarra::forms
