#pragma once

// Looks for an object beside the image: the head turns to the views that show the rest of the table within the arm's
// reach, and looks from each. Where the object shows, the head is turned so that the other objects show with it, and
// stays there: the operations need it in view. Else it turns back to where it stood.
//
//   const Result<bool> shown = co_await search.look_for("circle");
//   if (shown && !*shown) search.in_vain();                     // ", and the head looked in 5 other directions"
//
// A head that is away, or taken by somebody's `look-at`, is left alone. Failures: interrupted, hold-ups such as a stop,
// and the eyes'.

#include "agents/coordinator/perceive/eyes.hpp"
#include "agents/coordinator/perceive/head.hpp"
#include "agents/coordinator/plan/interruption.hpp"

namespace pizarra::coordinator {

class HeadSearch {
 public:
  // All outlive it.
  HeadSearch(const CoordinatorOptions& options, const TaskDomain& domain, Surroundings& surroundings, Story& story,
             Eyes& eyes, Head& head, const Interruption& interruption)
      : options_(options),
        domain_(domain),
        surroundings_(surroundings),
        story_(story),
        eyes_(eyes),
        head_(head),
        interruption_(interruption) {}

  // Whether it is seen now.
  Task<Result<bool>> look_for(std::string object);
  // The end of the sentence "circle is not seen" after a search in vain; empty where the head did not search.
  const std::string& in_vain() const { return in_vain_; }
  void begin() { in_vain_.clear(); }

 private:
  struct Search {
    std::string object;
    HeadCamera camera;
    HeadRange range;
    HeadTurn before;                       // how the head stood
    std::vector<Eigen::Vector3d> seen_mm;  // the marks that showed then
  };

  // None where no camera's place is known yet.
  std::optional<HeadCamera> camera() const;
  std::vector<Eigen::Vector3d> marks_in_view() const;
  Task<Result<bool>> look_around(Search search);
  Task<Result<bool>> look_from(HeadTurn view, std::string object);
  // As many of the objects as can be seen at once.
  Task<Result<void>> show_with_others(Search search);
  // A head that fails is no reason to give up looking.
  Task<Result<bool>> without_head(Failure why);

  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  Surroundings& surroundings_;
  Story& story_;
  Eyes& eyes_;
  Head& head_;
  const Interruption& interruption_;
  std::string in_vain_;
};

}  // namespace pizarra::coordinator
