#include "programs/hand_eye/turned_head.hpp"

namespace pizarra::hand_eye {

namespace {

constexpr const char* head_agent = "pan-tilt";
constexpr Duration head_patience = 40s;
constexpr Duration monitor_pause = 50ms;

ptu::PanTiltAxisRange range_from_datum(const Datum& axis) {
  return {axis[0].number(), axis[1].number(), axis[2].number(), axis[3].number()};
}

}  // namespace

Task<Result<Datum>> TurnedHead::ask(Datum operation) {
  return caller_.call(head_agent, std::move(operation), head_patience);
}

Task<Result<ptu::PanTiltRange>> TurnedHead::range() {
  const Datum pattern = list("pan-tilt-unit"_sym, "?"_sym, "?"_sym);
  const Result<std::vector<Fact>> units = co_await board_.facts(pattern);
  if (!units) co_return fail(units);
  if (units->empty())
    co_return fail("no-head", "no pan-tilt unit says how far it turns: see why in (ask (pan-tilt ? ?))");
  const Datum& unit = units->back().datum;
  co_return ptu::PanTiltRange{range_from_datum(unit[1]), range_from_datum(unit[2])};
}

Task<Result<ptu::HeadTurn>> TurnedHead::turn_to(ptu::HeadTurn turn) {
  const std::vector<Datum> moves{list("set-pan-pos"_sym, turn.pan_deg), list("set-tilt-pos"_sym, turn.tilt_deg)};
  for (const Datum& move : moves) {
    const Result<Datum> accepted = co_await ask(move);
    if (!accepted) co_return fail(accepted);
  }
  const Time deadline = executor_.now() + head_patience;
  const Datum monitor = list("monitor"_sym);
  while (executor_.now() < deadline) {
    const Result<Datum> at = co_await ask(monitor);
    if (!at) co_return fail(at);
    if (at->size() != 3) co_return fail("bad-reply", "the pan-tilt unit's monitor gives no angles", *at);
    if ((*at)[2].is_symbol("still")) co_return ptu::HeadTurn{(*at)[0].number(), (*at)[1].number()};
    co_await sleep(executor_, monitor_pause);
  }
  co_return fail("still-turning", "the pan-tilt unit does not come to rest");
}

}  // namespace pizarra::hand_eye
