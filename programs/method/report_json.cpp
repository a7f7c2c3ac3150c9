#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lisp/json.hpp"
#include "programs/method/report.hpp"

namespace pizarra::method {

namespace {

std::string strings(const auto& texts) {
  std::vector<std::string> quoted;
  for (const auto& text : texts) quoted.push_back(json_string(text));
  return fmt::format("[{}]", fmt::join(quoted, ","));
}

std::string component_json(const Component& component) {
  return fmt::format(
      "{{\"name\":{},\"kind\":{},\"level\":{},\"physical\":{},\"performance\":{},\"abstraction\":{},\"connections\":{}}"
      "}",
      json_string(component.name), json_string(component.kind), component.level, component.physical,
      component.performance, component.abstraction, component.connections);
}

std::string connection_json(const Connection& connection) {
  return fmt::format(
      "{{\"from\":{},\"to\":{},\"pattern\":{},\"about\":{},\"count\":{},\"bytes\":{:.1f},\"bytes_back\":{:.1f},"
      "\"p50_ms\":{:.3f},\"p99_ms\":{:.3f},\"addressees\":{},\"recommended\":{},\"remark\":{}}}",
      json_string(connection.from), json_string(connection.to), json_string(connection.pattern),
      strings(connection.about), connection.count, connection.bytes, connection.bytes_back, connection.p50_ms,
      connection.p99_ms, connection.addressees, json_string(connection.recommended), json_string(connection.remark));
}

std::string wrapping_json(const Wrapping& wrapping) {
  std::vector<std::string> indices;
  for (const AbstractionIndex& index : wrapping.indices) {
    indices.push_back(fmt::format("{{\"wrapped\":{},\"operations\":{},\"functions\":{},\"i_abstract\":{:.3f}}}",
                                  json_string(index.wrapped), index.operations, index.functions, index.value));
  }
  return fmt::format("{{\"component\":{},\"offered\":{},\"abstraction\":[{}],\"parts\":{}}}",
                     json_string(wrapping.component), wrapping.offered, fmt::join(indices, ","),
                     strings(wrapping.parts));
}

std::string fault_json(const Fault& fault) {
  return fmt::format("{{\"symbol\":{},\"subject\":{},\"sentence\":{}}}", json_string(fault.symbol),
                     json_string(fault.subject), json_string(fault.sentence));
}

std::string scale_json(const Scale& scale) {
  return fmt::format("{{\"subscribers\":{},\"p50_ms\":{:.3f}}}", scale.subscribers, scale.p50_ms);
}

std::string list_json(const auto& items, auto json) {
  std::vector<std::string> objects;
  for (const auto& item : items) objects.push_back(json(item));
  return fmt::format("[{}]", fmt::join(objects, ","));
}

}  // namespace

std::string json_of(const Report& report) {
  const Division& division = report.division;
  return fmt::format(
      "{{\"system\":{},\"seconds\":{:.1f},\"i_cpx\":{:.3f},\"i_struct\":{:.3f},\"i_cnx\":{:.3f},\"components\":{},"
      "\"wrappers\":{},\"connections\":{},\"scales\":{},\"faults\":{}}}",
      json_string(report.system.name), report.system.seconds, division.i_cpx, division.i_struct, division.i_cnx,
      list_json(report.system.components, component_json), list_json(report.wrappings, wrapping_json),
      list_json(report.system.connections, connection_json), list_json(report.scales, scale_json),
      list_json(report.faults, fault_json));
}

}  // namespace pizarra::method
