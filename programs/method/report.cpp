#include "programs/method/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pizarra::method {

namespace {

// "y" or "-", as in Table 5.1.
const char* tick(bool met) { return met ? "y" : "-"; }

std::string divide_text(const Report& report) {
  const Division& division = report.division;
  std::string out = "DIVIDE\n";
  out += fmt::format("  {:<18} {:>5} {:>9} {:>12} {:>12} {:>12}\n", "component", "level", "physical", "performance",
                     "abstraction", "connections");
  for (const Component& component : report.system.components) {
    out += fmt::format("  {:<18} {:>5} {:>9} {:>12} {:>12} {:>12}\n", component.name, component.level,
                       tick(component.physical), tick(component.performance), tick(component.abstraction),
                       component.connections);
  }
  out += fmt::format("  {:<18} {:>5} {:>9} {:>12} {:>12} {:>12}\n", fmt::format("all {}", division.components),
                     division.first_level, division.physical, division.performance, division.abstraction,
                     division.connections);
  out += fmt::format("  I_cpx    = {}/{} = {:.3f}\n", division.first_level, division.components, division.i_cpx);
  out += fmt::format("  I_struct = ({} + {} + {})/{} = {:.3f}\n", division.physical, division.performance,
                     division.abstraction, division.components, division.i_struct);
  out += fmt::format("  I_cnx    = {}/({} * {}) = {:.3f}\n", division.connections, division.components,
                     division.components == 0 ? 0 : division.components - 1, division.i_cnx);
  return out;
}

std::string wrap_text(const std::vector<Wrapping>& wrappings) {
  if (wrappings.empty()) return "";
  std::string out = "\nWRAP\n";
  for (const Wrapping& wrapping : wrappings) {
    out += fmt::format("  {:<18} {} operations offered\n", wrapping.component, wrapping.offered);
    for (const AbstractionIndex& index : wrapping.indices) {
      out += fmt::format("    I_abstract = {}/{} = {:.3f}  {}\n", index.operations, index.functions, index.value,
                         index.wrapped);
    }
    std::vector<std::string> has, lacks;
    for (const char* part : wrapper_parts) (wrapping.parts.contains(part) ? has : lacks).emplace_back(part);
    out += fmt::format("    has   {}\n",
                       has.empty() ? "none of a wrapper's parts" : fmt::format("{}", fmt::join(has, ", ")));
    if (!lacks.empty()) out += fmt::format("    lacks {}\n", fmt::join(lacks, ", "));
  }
  return out;
}

std::string matrix_text(const System& system) {
  std::string out = fmt::format("  {:<18}", "from \\ to");
  for (const Component& to : system.components) out += fmt::format(" {:>12.12}", to.name);
  out += '\n';
  for (const Component& from : system.components) {
    out += fmt::format("  {:<18}", from.name);
    for (const Component& to : system.components) {
      std::string cell;
      for (const Connection& connection : system.connections) {
        if (connection.from != from.name || connection.to != to.name) continue;
        cell += (cell.empty() ? "" : "+") + connection.pattern;
      }
      out += fmt::format(" {:>12}", cell.empty() ? "." : cell);
    }
    out += '\n';
  }
  return out;
}

std::string connections_text(const System& system) {
  std::string out = fmt::format("\n  {:<30} {:<7} {:>9} {:>8} {:>8} {:>9} {:>9}  {}\n", "connection", "pattern",
                                "count/s", "bytes", "back", "p50 ms", "p99 ms", "Table 4.5");
  const auto figure = [&](double value, int digits) {
    return system.seconds > 0 ? fmt::format("{:.{}f}", value, digits) : std::string("-");
  };
  const auto measured = [&](double ms) { return ms > 0 ? figure(ms, 2) : std::string("-"); };
  for (const Connection& connection : system.connections) {
    const double rate = system.seconds > 0 ? static_cast<double>(connection.count) / system.seconds : 0;
    out += fmt::format("  {:<30} {:<7} {:>9} {:>8} {:>8} {:>9} {:>9}  {}\n",
                       fmt::format("{} -> {}", connection.from, connection.to), connection.pattern, figure(rate, 2),
                       figure(connection.bytes, 0), figure(connection.bytes_back, 0), measured(connection.p50_ms),
                       measured(connection.p99_ms), connection.recommended);
  }
  return out;
}

std::string connect_text(const Report& report) {
  std::string out = "\nCONNECT (the design matrix; rows begin)\n" + matrix_text(report.system);
  bool advised = false;
  for (const Connection& connection : report.system.connections) advised = advised || !connection.recommended.empty();
  if (advised) out += connections_text(report.system);
  for (const Connection& connection : report.system.connections) {
    if (!connection.remark.empty()) out += fmt::format("  - {}\n", connection.remark);
  }
  if (!report.scales.empty()) {
    out += "  a fact reaches all of its subscribers (median):";
    for (const Scale& scale : report.scales) out += fmt::format(" {} in {:.2f} ms;", scale.subscribers, scale.p50_ms);
    out.back() = '\n';
  }
  return out;
}

}  // namespace

Report report_on(const Traffic& traffic, const std::map<std::string, Component>& kinds,
                 const std::vector<Wrapped>& lists) {
  Report report;
  report.system = system_of(traffic, kinds);
  report.division = divide(report.system);
  report.wrappings = wrap(traffic, lists, kinds);
  report.faults = faults_of(traffic);
  report.scales = traffic.scales;
  report.watches_seen = traffic.watches_seen;
  return report;
}

Report report_on(System system) {
  Report report;
  report.division = divide(system);
  report.system = std::move(system);
  return report;
}

std::string text_of(const Report& report) {
  std::string out = report.system.name;
  if (report.system.seconds > 0) out += fmt::format(", {:.1f} s of it", report.system.seconds);
  out += "\n\n" + divide_text(report) + wrap_text(report.wrappings) + connect_text(report);
  if (report.wrappings.empty()) return out;
  out += "\nFAULTS\n";
  for (const Fault& fault : report.faults) out += fmt::format("  {:<16} {}\n", fault.symbol, fault.sentence);
  if (report.faults.empty()) out += "  none found\n";
  if (!report.watches_seen) out += "  who reads is taken from the contracts: only a running board knows who watches\n";
  return out;
}

}  // namespace pizarra::method
