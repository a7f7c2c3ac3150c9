#pragma once

// A system of components as the method of the thesis looks at it: what each component is, who is connected with whom,
// and what was seen of that. Nothing here asks a board or prints: descriptions, contracts and traffic come in, indices,
// patterns and faults go out.
//
//   const Traffic traffic = traffic_of_journal(text).value();
//   const System system = system_of(traffic, known_components().value());
//   divide(system).i_cnx;
//   for (const Fault& fault : faults_of(traffic)) ...

#include <map>
#include <set>
#include <string>
#include <vector>

#include "lisp/datum.hpp"

namespace pizarra::method {

// Why something is a component of its own (Table 5.1), and which parts of a wrapper a contract does not show.
struct Component {
  std::string name;
  std::string kind;
  int level = 1;  // 2: a part of other components
  bool physical = false;
  bool performance = false;
  bool abstraction = false;
  int connections = 0;         // that begin here
  std::set<std::string> does;  // transformation, interpretation, distribution, collection, processing
};

// One cell of the design matrix (Tables 5.2 to 5.4).
struct Connection {
  std::string from;
  std::string to;
  std::string pattern;            // QUERY, SEND, PUSH, EVENT, STREAM: images, beside the board
  std::set<std::string> about;    // operations, relations or streams
  std::size_t count = 0;          // exchanges or facts, as far as they were seen
  double bytes = 0;               // of one, towards `to`
  double bytes_back = 0;          // of its answer
  double p50_ms = 0, p99_ms = 0;  // until the answer, or the delivery; 0: not measured
  std::size_t addressees = 1;
  std::string recommended = {};
  std::string remark = {};  // where the two differ
};

struct System {
  std::string name;
  double seconds = 0;  // that were looked at; 0: nothing was
  std::vector<Component> components;
  std::vector<Connection> connections;
};

// Requests of one client to one server for one operation.
struct Exchange {
  std::size_t asked = 0, answered = 0, misfit = 0;  // misfit: refused as not offered, or not in that form
  double bytes = 0, bytes_back = 0;                 // of all
  double oldest_open_s = 0;                         // that was asked and not answered when the look ended
  std::vector<double> took_ms;
};
struct ExchangeKey {
  std::string client, server, operation;
  bool waits = true;  // the client, for the answer
  auto operator<=>(const ExchangeKey&) const = default;
};

// What is told of one relation.
struct Flow {
  std::map<std::string, std::size_t> told;   // by agent
  std::set<std::string> watchers;            // agents
  std::set<std::string> askers;              // agents
  std::map<std::string, std::size_t> taken;  // by agent
  double mean_bytes = 0;
  double delivered_p50_ms = 0, delivered_p99_ms = 0;
};

// Images that somebody publishes.
struct ImagesSeen {
  std::string teller;
  double per_second = 0;  // 0: not measured
  double bytes = 0;       // of one
};

struct AgentSeen {
  std::string kind;
  Datum contract;  // an empty list where none was seen
};

// How long a fact took to the last of so many subscribers.
struct Scale {
  std::size_t subscribers;
  double p50_ms;
};

struct Traffic {
  std::string name;
  double seconds = 0;
  bool watches_seen = false;  // a journal and a cell file say nothing of who watches: contracts say who reads
  std::map<std::string, AgentSeen> agents;
  std::map<ExchangeKey, Exchange> exchanges;
  std::map<std::string, Flow> flows;
  std::map<std::string, ImagesSeen> streams;
  std::vector<Scale> scales;
};

// The names in a contract's part: offers, posts, reads, takes, configures, monitors.
std::set<std::string> names_in(const Datum& contract, std::string_view part);
// A relation that every agent tells or watches through the runtime, or who measures the board: it says nothing of the
// system.
bool is_of_every_agent(const std::string& relation);
// Prompts, tools and tellers of stories: they use the cell and are no part of it.
bool is_visitor(const std::string& kind);
// Who reads it: those seen to watch it or ask for it, or, where that is not seen, those whose contract says so.
std::set<std::string> readers_of(const Traffic& traffic, const std::string& relation);
// Who takes facts of it: those seen to, and those whose contract says so.
std::set<std::string> takers_of(const Traffic& traffic, const std::string& relation);

// What the traffic is as components and connections; criteria of kinds that are not known are none.
System system_of(const Traffic& traffic, const std::map<std::string, Component>& kinds);

}  // namespace pizarra::method
