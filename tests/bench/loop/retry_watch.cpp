#include "tests/bench/loop/retry_watch.hpp"

namespace pizarra::bench {

namespace {

// Fingers that close by more had something between them.
constexpr double closed_mm = 3;

}  // namespace

void RetryWatch::take(const Datum& fact, double now_s) {
  if (fact.is_form("gripper")) return take_opening(fact[2].number(), now_s);
  if (fact.is_form("micro-task")) return take_step(fact[2], fact[3].text(), now_s);
  if (!fact.is_form("event")) return;
  const bool differs = fact[2].is_symbol("difference");
  const bool begins = fact[2].is_symbol("operation") && !fact[4].is_form("fail");
  if (differs) pass(1, now_s);
  if (fact[2].is_symbol("operation") && !begins) pass(1, now_s);
  if (begins) pass(2, now_s);
}

void RetryWatch::take_opening(double opening_mm, double now_s) {
  opening_mm_ = opening_mm;
  if (!held_mm_ || opening_mm > *held_mm_ - closed_mm) return;
  held_mm_.reset();
  reached_s_ = {now_s};
}

void RetryWatch::take_step(const Datum& step, std::string_view state, double now_s) {
  if (state == "failed") pass(1, now_s);
  if (step.is_form("release") || step.is_form("open")) held_mm_.reset();
  if (!step.is_form("close")) return;
  if (state == "running") pass(3, now_s);
  if (state != "done") return;
  pass(4, now_s);
  held_mm_ = opening_mm_;
}

// A part that is passed while one before it was not ends both.
void RetryWatch::pass(std::size_t part, double now_s) {
  if (reached_s_.empty() || reached_s_.size() > part) return;
  reached_s_.resize(part + 1, now_s);
  if (part < Retry::parts) return;
  Retry retry{};
  for (std::size_t i = 0; i < Retry::parts; ++i) retry.part_s[i] = reached_s_[i + 1] - reached_s_[i];
  retries_.push_back(retry);
  reached_s_.clear();
}

}  // namespace pizarra::bench
