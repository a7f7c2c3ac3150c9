#pragma once

// The bytes that wait for one reader, in the queue of one watch or of several that share them.
//
//   auto backlog = std::make_shared<Backlog>();
//   Backlog::Share waiting(backlog);                 // of one queue
//   if (!waiting.add(bytes)) ...                     // there is no room for them
//   waiting.remove(bytes);

#include <cstddef>
#include <memory>

#include "blackboard/limits.hpp"

namespace pizarra::watch {

class Backlog {
 public:
  class Share {
   public:
    explicit Share(std::shared_ptr<Backlog> backlog) : backlog_(std::move(backlog)) {}
    Share(const Share&) = delete;
    Share& operator=(const Share&) = delete;
    ~Share() { clear(); }

    std::size_t bytes() const { return bytes_; }
    const Backlog* backlog() const { return backlog_.get(); }
    bool add(std::size_t bytes) {
      if (backlog_->bytes_ + bytes > limits::pending_bytes) return false;
      backlog_->bytes_ += bytes;
      bytes_ += bytes;
      return true;
    }
    void remove(std::size_t bytes) {
      backlog_->bytes_ -= bytes;
      bytes_ -= bytes;
    }
    void clear() { remove(bytes_); }

   private:
    const std::shared_ptr<Backlog> backlog_;
    std::size_t bytes_ = 0;
  };

 private:
  std::size_t bytes_ = 0;
};

}  // namespace pizarra::watch
