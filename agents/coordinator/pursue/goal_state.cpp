#include "agents/coordinator/pursue/goal_state.hpp"

namespace pizarra::coordinator {

Datum told_missing(const std::vector<std::string>& names) {
  std::vector<Datum> detail{"missing"_sym};
  for (const std::string& name : names) detail.push_back(Datum::symbol(name));
  return Datum::list(std::move(detail));
}

Datum told_in_stage(std::size_t stage, const Datum& detail) {
  if (stage == 0) return detail;
  std::vector<Datum> told{"stage"_sym, to_datum(static_cast<std::int64_t>(stage + 1))};
  if (detail != Datum()) told.push_back(detail);
  return Datum::list(std::move(told));
}

std::size_t stage_told(const Datum& detail) {
  const bool is_told = detail.is_form("stage") && detail.size() >= 2 && detail[1].is_integer();
  return is_told && detail[1].integer() > 0 ? static_cast<std::size_t>(detail[1].integer() - 1) : 0;
}

}  // namespace pizarra::coordinator
