#include "blackboard/time/virtual_executor.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {

namespace {

class MemoryWall : public Wall {
 public:
  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override { return board_.view(teller); }

 private:
  VirtualExecutor executor_;
  MemoryBoard board_{executor_};
};

}  // namespace

std::vector<WallKind> all_walls() {
  return {{"memory", [] { return std::make_unique<MemoryWall>(); }}};
}

}  // namespace pizarra
