#pragma once

// Finds what stands elsewhere by a hash that the caller knows: open addressing, no allocation for each entry, nothing
// kept but the hash and the pointer. Which of the entries with a hash is meant, the caller says. Its order is nobody's
// to see.
//
//   HashIndex<Entry> by_key;
//   by_key.insert(hash, entry);
//   Entry* found = by_key.find(hash, [&](const Entry& e) { return e.key == key; });     // null where there is none
//   by_key.erase(hash, entry);

#include <bit>
#include <cstddef>
#include <vector>

namespace pizarra::store {

template <class Entry>
class HashIndex {
 public:
  std::size_t size() const { return size_; }

  template <class Wanted>
  Entry* find(std::size_t hash, Wanted&& wanted) const {
    if (slots_.empty()) return nullptr;
    for (std::size_t at = home_of(hash); slots_[at].entry != nullptr; at = after(at)) {
      if (slots_[at].hash == hash && wanted(*slots_[at].entry)) return slots_[at].entry;
    }
    return nullptr;
  }

  void insert(std::size_t hash, Entry* entry) {
    if ((size_ + 1) * 3 > slots_.size() * 2) grow();
    put({hash, entry});
    ++size_;
  }

  // It must be there.
  void erase(std::size_t hash, const Entry* entry) {
    std::size_t hole = home_of(hash);
    while (slots_[hole].entry != entry) hole = after(hole);
    --size_;
    // Whatever was put further on because this place was taken moves up, so that no search ends at the hole.
    for (std::size_t at = after(hole); slots_[at].entry != nullptr; at = after(at)) {
      const std::size_t home = home_of(slots_[at].hash);
      const bool may_move = ((at - home) & mask()) >= ((at - hole) & mask());
      if (!may_move) continue;
      slots_[hole] = slots_[at];
      hole = at;
    }
    slots_[hole] = {};
  }

 private:
  struct Slot {
    std::size_t hash = 0;
    Entry* entry = nullptr;
  };
  static constexpr std::size_t smallest = 16;

  std::size_t mask() const { return slots_.size() - 1; }
  std::size_t after(std::size_t at) const { return (at + 1) & mask(); }
  // The high bits of the product depend on all bits of the hash.
  std::size_t home_of(std::size_t hash) const {
    return (hash * std::size_t{0x9e3779b97f4a7c15}) >> (64 - std::countr_zero(slots_.size()));
  }

  void put(Slot slot) {
    std::size_t at = home_of(slot.hash);
    while (slots_[at].entry != nullptr) at = after(at);
    slots_[at] = slot;
  }

  void grow() {
    std::vector<Slot> before(slots_.empty() ? smallest : slots_.size() * 2);
    before.swap(slots_);
    for (const Slot& slot : before) {
      if (slot.entry != nullptr) put(slot);
    }
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

}  // namespace pizarra::store
