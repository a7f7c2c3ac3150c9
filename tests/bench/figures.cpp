#include "tests/bench/figures.hpp"

#include <fmt/format.h>

#include "lisp/json.hpp"

namespace pizarra::bench {

namespace {

// Four digits are more than a shared machine repeats.
std::string shown(const std::optional<double>& value) { return value ? fmt::format("{:.4g}", *value) : "-"; }

std::string json_number(const std::optional<double>& value) { return value ? fmt::format("{:.9g}", *value) : "null"; }

bool counts(const Goal& goal) { return goal.kind == Goal::Kind::at_most || goal.kind == Goal::Kind::at_least; }

bool reaches(const Goal& goal, double value) {
  return goal.kind == Goal::Kind::at_most ? value <= goal.bound : value >= goal.bound;
}

std::string verdict_of(const Figure& figure) {
  if (!counts(figure.goal)) return "";
  return figure.value && reaches(figure.goal, *figure.value) ? "met" : "SHORT";
}

std::string remark_on(const Figure& figure) {
  if (figure.limit.empty() || verdict_of(figure) != "SHORT") return figure.note;
  return figure.note + (figure.note.empty() ? "" : "; ") + "limited by " + figure.limit;
}

std::string plain_line(const Figure& figure) {
  std::string line = fmt::format("{:<44} {:>10} {:<6}", figure.name, shown(figure.value), figure.unit);
  line += fmt::format("  goal {:<28}", figure.goal.kind == Goal::Kind::none ? "-" : figure.goal.text);
  for (const Peer& peer : figure.peers) line += fmt::format("  {} {}", peer.name, shown(peer.value));
  const std::string verdict = verdict_of(figure);
  if (!verdict.empty()) line += "  " + verdict;
  const std::string remark = remark_on(figure);
  if (!remark.empty()) line += "  (" + remark + ")";
  return line;
}

std::string json_line(const std::string& bench, const Figure& figure) {
  std::string peers;
  for (const Peer& peer : figure.peers) {
    peers += fmt::format("{}{}:{}", peers.empty() ? "" : ",", json_string(peer.name), json_number(peer.value));
  }
  return fmt::format(
      R"({{"bench":{},"figure":{},"value":{},"unit":{},"goal":{},"verdict":{},"peers":{{{}}},"note":{}}})",
      json_string(bench), json_string(figure.name), json_number(figure.value), json_string(figure.unit),
      json_string(figure.goal.text), json_string(verdict_of(figure)), peers, json_string(remark_on(figure)));
}

}  // namespace

Goal at_most(double bound, std::string text) {
  if (text.empty()) text = fmt::format("<= {:.4g}", bound);
  return {std::move(text), Goal::Kind::at_most, bound};
}

Goal at_least(double bound, std::string text) {
  if (text.empty()) text = fmt::format(">= {:.4g}", bound);
  return {std::move(text), Goal::Kind::at_least, bound};
}

Goal not_comparable(std::string why) { return {"n/a: " + std::move(why), Goal::Kind::not_comparable, 0}; }

Figures::Figures(std::string bench, Style style, std::FILE* out) : bench_(std::move(bench)), style_(style), out_(out) {}

void Figures::say(const Figure& figure) {
  fmt::print(out_, "{}\n", style_ == Style::json ? json_line(bench_, figure) : plain_line(figure));
  std::fflush(out_);
  if (!figure.value) ++unmeasured_;
  if (!counts(figure.goal)) return;
  ++goals_;
  if (figure.value && reaches(figure.goal, *figure.value)) ++met_;
}

void Figures::must_be_none(const std::string& what, int found) {
  if (found == 0) return;
  ++wrong_;
  if (style_ == Style::json) {
    fmt::print(out_, "{{\"bench\":{},\"wrong\":{},\"found\":{}}}\n", json_string(bench_), json_string(what), found);
  } else {
    fmt::print(out_, "WRONG: {} {}\n", what, found);
  }
}

int Figures::finish() {
  if (style_ == Style::json) {
    fmt::print(out_, "{{\"bench\":{},\"goals_met\":{},\"goals\":{},\"unmeasured\":{}}}\n", json_string(bench_), met_,
               goals_, unmeasured_);
  } else {
    if (unmeasured_ > 0) fmt::print(out_, "not measured: {}\n", unmeasured_);
    fmt::print(out_, "goals met {} of {}\n", met_, goals_);
  }
  return unmeasured_ == 0 && wrong_ == 0 ? 0 : 1;
}

}  // namespace pizarra::bench
