#pragma once

// A look of the eyes as what holds: where its objects stand, and what the domain's rules find. One call of the embedded
// Scheme interprets the look's TRACK reply (vision_reply.hpp) and follows the rules (lisp/modules/pizarra/looks.scm).
//
//   Result<PerceivedLook> look = perceive_look(perception, text, of, situation, believed);
//   look->seen[0].at_mm;                  // where the first object that the reply names stands, base frame
//   look->facts;                          // what the domain's rules find: (on circle triangle) ...

#include <array>
#include <optional>
#include <string_view>

#include "lisp/forms/perception.hpp"

namespace pizarra::forms {

// The situation in which a reply is understood. Points and directions are lists (X Y Z), mm, in the base frame.
struct LookSituation {
  Datum camera;                   // (FOCAL CX CY BASE-LINE CENTRE ACROSS DOWN FORWARD)
  Datum hand;                     // (MARK OFFSET GRIP HALF-WIDTH BELOW MARK-HALF), GRIP () where it is not known
  std::vector<Datum> remembered;  // (NAME PLACE AGE EXCUSABLE), of AGE looks ago; EXCUSABLE 0 or 1
  std::vector<Datum> measured;    // facts besides what is seen, such as (gripper 60.2)
};

struct SeenObject {
  std::string name;
  std::array<double, 3> at_mm;     // of its mark
  std::optional<double> face_deg;  // as the look says it
};

struct PerceivedLook {
  std::vector<SeenObject> seen;
  std::vector<std::string> hidden;  // by the gripper, of what is remembered
  // Failure: too-much-work, as Perception::perceive has it.
  Result<std::vector<Datum>> facts;
};

// `text` is a TRACK reply, and `of` what the look tells besides: ((NAME STATE CONFIDENCE (face DEGREES) ...) ...).
// Failures: the reader's, and the same of the text.
Result<PerceivedLook> perceive_look(const Perception& perception, std::string_view text, const Datum& of,
                                    const LookSituation& situation, const std::vector<Datum>& believed);

}  // namespace pizarra::forms
