#pragma once

// A flag that is up for as long as this lives, whatever ends a coroutine.
//
//   const Held ordering(ordering_);

namespace pizarra::arm {

class Held {
 public:
  explicit Held(bool& flag) : flag_(flag) { flag_ = true; }
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;
  ~Held() { flag_ = false; }

 private:
  bool& flag_;
};

}  // namespace pizarra::arm
