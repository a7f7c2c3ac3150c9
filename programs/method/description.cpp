#include "programs/method/description.hpp"

#include <algorithm>
#include <array>

#include "lisp/reader.hpp"

namespace pizarra::method {

namespace {

using Path = std::vector<std::size_t>;

Path below(Path path, std::size_t index) {
  path.push_back(index);
  return path;
}

Failure wrong(const Source& source, const Path& path, const char* sentence) {
  return source.failure_at(path, "bad-description", sentence);
}

// One part of a component: (level N), (connections N), (does PART ...), or a criterion.
Result<void> read_part(const Source& source, const Datum& part, const Path& path, Component& component) {
  constexpr std::array does = {"transformation", "interpretation", "distribution", "collection", "processing"};
  const bool counted = part.size() == 2 && part[1].is_integer() && part[1].integer() >= 0;
  if (part.is_form("level") && counted && (part[1].integer() == 1 || part[1].integer() == 2)) {
    component.level = static_cast<int>(part[1].integer());
  } else if (part.is_form("connections") && counted && part[1].integer() <= 1000) {
    component.connections = static_cast<int>(part[1].integer());
  } else if (part.is_form("physical") && part.size() == 1) {
    component.physical = true;
  } else if (part.is_form("performance") && part.size() == 1) {
    component.performance = true;
  } else if (part.is_form("abstraction") && part.size() == 1) {
    component.abstraction = true;
  } else if (part.is_form("does")) {
    for (std::size_t i = 1; i < part.size(); ++i) {
      if (std::ranges::find(does, part[i].text()) == does.end()) {
        return fail(wrong(source, below(path, i),
                          "a wrapper does transformation, interpretation, distribution, collection or "
                          "processing"));
      }
      component.does.emplace(part[i].text());
    }
  } else {
    return fail(wrong(source, path,
                      "a component's part is (level 1), (level 2), (physical), (performance), (abstraction), "
                      "(connections N) or (does PART ...)"));
  }
  return {};
}

Result<Component> read_component(const Source& source, const Datum& form, const Path& path) {
  if (form.size() < 2 || !form[1].is_symbol()) {
    return fail(wrong(source, path, "a component is (component NAME PART ...)"));
  }
  Component component;
  component.name = form[1].text();
  component.kind = form[1].text();
  for (std::size_t i = 2; i < form.size(); ++i) {
    const Result<void> read = read_part(source, form[i], below(path, i), component);
    if (!read) return fail(read);
  }
  return component;
}

Result<Connection> read_connection(const Source& source, const Datum& form, const Path& path, const System& system) {
  constexpr std::array patterns = {"SEND", "QUERY", "PUSH", "EVENT", "WIRING"};
  if (form.size() != 4) return fail(wrong(source, path, "a connection is (connection FROM TO PATTERN)"));
  for (std::size_t end : {1, 2}) {
    if (std::ranges::find(system.components, form[end].text(), &Component::name) == system.components.end()) {
      return fail(wrong(source, below(path, end), "there is no component of this name above"));
    }
  }
  if (std::ranges::find(patterns, form[3].text()) == patterns.end()) {
    return fail(wrong(source, below(path, 3), "a pattern is SEND, QUERY, PUSH, EVENT or WIRING"));
  }
  Connection connection;
  connection.from = form[1].text();
  connection.to = form[2].text();
  connection.pattern = form[3].text();
  return connection;
}

Result<Wrapped> read_wrapped(const Source& source, const Datum& form, const Path& path) {
  if (!form.is_form("wrapped") || form.size() < 4 || !form[1].is_symbol() || !form[2].is_string()) {
    return fail(wrong(source, path, "a list is (wrapped KIND \"NAME\" (operations ...) (functions (PART N) ...))"));
  }
  Wrapped wrapped{
      .kind = std::string(form[1].text()), .name = std::string(form[2].text()), .operations = {}, .functions = 0};
  for (std::size_t i = 3; i < form.size(); ++i) {
    for (std::size_t k = 1; k < form[i].size(); ++k) {
      const Datum& item = form[i][k];
      const bool counted = item.size() == 2 && item[1].is_integer() && item[1].integer() > 0;
      if (form[i].is_form("operations") && item.is_symbol()) {
        wrapped.operations.emplace(item.text());
      } else if (form[i].is_form("functions") && counted) {
        wrapped.functions += static_cast<std::size_t>(item[1].integer());
      } else if (form[i].is_form("functions") && item.is_symbol()) {
        ++wrapped.functions;
      } else {
        return fail(wrong(source, below(below(path, i), k), "operations are names, functions names or (PART N)"));
      }
    }
  }
  return wrapped;
}

}  // namespace

bool is_system_file(const std::string& path) {
  const Result<Source> source = read_source_file(path);
  return source && !source->data().empty() && source->data().front().is_form("system");
}

Result<System> read_system(const std::string& path) {
  const Result<Source> source = read_source_file(path);
  if (!source) return fail(source);
  const bool shaped = source->data().size() == 1 && source->data()[0].is_form("system") && source->data()[0].size() > 1;
  if (!shaped)
    return fail(wrong(*source, {0}, "a system is (system \"NAME\" (component ...) ... (connection ...) ...)"));
  const Datum& form = source->data()[0];
  System system{.name = std::string(form[1].text()), .components = {}, .connections = {}};
  for (std::size_t i = 2; i < form.size(); ++i) {
    if (form[i].is_form("component")) {
      Result<Component> component = read_component(*source, form[i], {0, i});
      if (!component) return fail(component);
      system.components.push_back(std::move(*component));
    } else if (form[i].is_form("connection")) {
      Result<Connection> connection = read_connection(*source, form[i], {0, i}, system);
      if (!connection) return fail(connection);
      system.connections.push_back(std::move(*connection));
    } else {
      return fail(wrong(*source, {0, i}, "a system has its components first, then its connections"));
    }
  }
  return system;
}

Result<std::map<std::string, Component>> known_components(const std::string& more) {
  std::map<std::string, Component> kinds;
  for (const std::string& file : {std::string(PIZARRA_METHOD) + "/components.scm", more}) {
    if (file.empty()) continue;
    const Result<Source> source = read_source_file(file);
    if (!source) return fail(source);
    for (std::size_t i = 0; i < source->data().size(); ++i) {
      const Datum& form = source->data()[i];
      if (!form.is_form("component")) return fail(wrong(*source, {i}, "a component is (component KIND PART ...)"));
      Result<Component> component = read_component(*source, form, {i});
      if (!component) return fail(component);
      kinds[component->kind] = std::move(*component);
    }
  }
  return kinds;
}

Result<std::vector<Wrapped>> known_wrapped() {
  constexpr std::array drivers = {"arm/simple_message", "arm/motoman", "ptu"};
  std::vector<Wrapped> lists;
  for (const char* driver : drivers) {
    const Result<Source> source = read_source_file(std::string(PIZARRA_DRIVERS) + "/" + driver + "/wrapped.scm");
    if (!source) return fail(source);
    for (std::size_t i = 0; i < source->data().size(); ++i) {
      Result<Wrapped> wrapped = read_wrapped(*source, source->data()[i], {i});
      if (!wrapped) return fail(wrapped);
      lists.push_back(std::move(*wrapped));
    }
  }
  return lists;
}

}  // namespace pizarra::method
