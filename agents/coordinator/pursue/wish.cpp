#include "agents/coordinator/pursue/wish.hpp"

#include <chrono>

namespace pizarra::coordinator {

Wish wish_of(const std::vector<Datum>& goal) {
  Wish wish;
  std::vector<Datum> together;
  for (const Datum& form : goal) {
    const std::span<const Datum> parts = form.items();
    if (form.is_form("wait")) {
      wish.patience = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(form[1].number()));
    } else if (form.is_form("then")) {
      for (const Datum& stage : parts.subspan(1)) {
        const bool joined = stage.is_form("and");
        wish.stages.push_back(joined ? std::vector<Datum>(stage.items().begin() + 1, stage.items().end())
                                     : std::vector<Datum>{stage});
      }
    } else if (form.is_form("keep")) {
      wish.keeps = true;
      together.insert(together.end(), parts.begin() + 1, parts.end());
    } else {
      together.push_back(form);
    }
  }
  if (!together.empty()) wish.stages.push_back(std::move(together));
  return wish;
}

}  // namespace pizarra::coordinator
