#pragma once

// Names for agents in a tree of contexts, as facts:
//
//   (context (PARENT ...) NAME)              a branch of the tree; durable
//   (bound (PARENT ...) NAME KIND AGENT)     who is meant by the name, under the presence of who bound it
//
//   Naming naming(context, service);                              // after service.start()
//   co_await naming.make_context({"robots", "crs-f3"});            // and what is missing above it
//   co_await naming.bind({"robots", "crs-f3", "left"}, {"robot", "robot-1"});
//   Result<Reference> arm = co_await naming.resolve({"robots", "crs-f3", "left"});
//   co_await caller.call(arm->agent, operation, 10s);
//
// A binding names an agent that is present and of that kind. It goes with its binder's presence, and is told again when
// the presence begins anew. So no name leads nowhere, and a server that comes back finds its name free. A context can
// be removed only when it is empty, and nothing can be bound in a context that is not there, so no part of the tree is
// cut off. This holds with any number of clients at once, because every change is one transaction.
//
// Names are plain (lisp/plain_name.hpp); a path has `max_depth` at most.

#include <map>
#include <string>
#include <vector>

#include "agents/runtime/service.hpp"

namespace pizarra::runtime {

using Path = std::vector<std::string>;

struct Reference {
  std::string kind;
  std::string agent;
  bool operator==(const Reference&) const = default;
};

struct NamedEntry {
  Path path;
  std::optional<Reference> reference;  // none: a context
  bool operator==(const NamedEntry&) const = default;
};

// Contexts first, by path.
struct Listing {
  std::vector<NamedEntry> entries;
  bool cut = false;  // there are more
};

std::vector<Relation> naming_relations();
// "robots/crs-f3/left"
std::string path_text(const Path& path);

class Naming {
 public:
  static constexpr std::size_t max_depth = 16;
  static constexpr std::size_t max_listed = 1000;

  // Both outlive it.
  Naming(AgentContext& context, const Service& service) : context_(context), service_(service) {}

  Task<Result<void>> declare();

  // Making what is there changes nothing. Failures bad-name, already-bound.
  Task<Result<void>> make_context(Path path);
  // Failures bad-name, no-context, absent (no agent of that name and kind is present), already-bound. Binding the same
  // again changes nothing.
  Task<Result<void>> bind(Path path, Reference reference);
  // In place of whatever is bound there, if anything. Failures bad-name, no-context, absent, already-bound (a context).
  Task<Result<void>> rebind(Path path, Reference reference);
  // A name that is not bound (any more) does no harm. Failure bad-name.
  Task<Result<void>> unbind(Path path);
  // Everything that was bound by this object, at once.
  Task<Result<void>> unbind_all();
  // Failures bad-name, not-empty.
  Task<Result<void>> remove_context(Path path);

  // Failure unbound, which names the nearest name beside it.
  Task<Result<Reference>> resolve(Path path);
  // Waits for it to be bound; failure timeout.
  Task<Result<Reference>> await(Path path, Time deadline);
  // The names in a context; at most max_listed. Failure no-context.
  Task<Result<Listing>> list(Path path);
  // Whatever is bound of a kind, wherever in the tree; at most max_listed.
  Task<Result<Listing>> find(std::string kind);

 private:
  Task<Result<std::vector<Fact>>> look(Datum pattern, std::size_t limit);
  Task<Result<void>> put(Path path, Reference reference, bool replace);
  Task<Result<void>> tell_bindings();
  Task<void> keep_bindings();

  AgentContext& context_;
  const Service& service_;
  std::map<Path, Reference> bound_;
  LeaseId told_under_ = 0;
  Job keeping_;
};

}  // namespace pizarra::runtime
