#pragma once

// Things that stand on one another, such as a line, its driver and a job: kept together, and let go in the opposite
// order.
//
//   Parts parts;
//   auto& wire = parts.add<line::TcpWire>(executor, "10.0.0.5", 80);
//   auto& link = parts.add<EthernetLine>(executor, wire);

#include <memory>
#include <utility>
#include <vector>

namespace pizarra {

class Parts {
 public:
  Parts() = default;
  Parts(Parts&&) = default;
  Parts& operator=(Parts&&) = delete;
  ~Parts() {
    while (!kept_.empty()) kept_.pop_back();
  }

  template <class Part, class... Arguments>
  Part& add(Arguments&&... arguments) {
    return keep(std::make_unique<Part>(std::forward<Arguments>(arguments)...));
  }

  // What was made elsewhere.
  template <class Part>
  Part& keep(std::unique_ptr<Part> part) {
    Part& kept = *part;
    kept_.push_back(std::shared_ptr<Part>(std::move(part)));
    return kept;
  }

 private:
  std::vector<std::shared_ptr<void>> kept_;
};

}  // namespace pizarra
