#pragma once

// The pan-tilt agent's contract: operations, facts, settings.

#include <string_view>

namespace pizarra::pan_tilt {

inline constexpr std::string_view pan_tilt_contract = R"scheme(
(contract pan-tilt
  (offers (pt-init) (pt-close)
          (set-pan-speed (percent number)) (set-tilt-speed (percent number))
          (set-pan-pos (degrees number)) (set-tilt-pos (degrees number))
          (set-pan-rel-pos (degrees number)) (set-tilt-rel-pos (degrees number))
          (reset-all) (reset-pan) (reset-tilt)
          (look-at (name symbol)) (look-ahead) (monitor))
  (posts (relation pan-tilt ((state symbol) (trouble string)) (key))
         (relation pan-tilt-unit ((pan list) (tilt list)) (key))
         (relation head ((pan number) (tilt number) (state symbol)) (key))
         (relation looking-at ((name symbol)) (key))
         (relation head-speed ((pan number) (tilt number)) (key) (durable)))
  (reads place head-speed)
  (configures set-pan-speed set-tilt-speed)
  (monitors monitor))
)scheme";

}  // namespace pizarra::pan_tilt
