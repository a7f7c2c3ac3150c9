#pragma once

// Numbers as binary protocols write them, in either byte order.
//
//   OctetWriter message(ByteOrder::little);
//   message.text("YERC").u16(32).i32(-7);
//   OctetReader read(message.octets(), ByteOrder::little);
//   read.text(4); read.u16(); read.i32();
//   read.whole()      // everything that was read was there, and nothing is left
//
// Reading beyond the end gives zeros, and sound() is false from then on: a message is taken apart first and judged
// once.

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace pizarra::line {

enum class ByteOrder : std::uint8_t { little, big };

class OctetWriter {
 public:
  explicit OctetWriter(ByteOrder order) : order_(order) {}
  OctetWriter& u8(std::uint8_t value) { return number(value, 1); }
  OctetWriter& u16(std::uint16_t value) { return number(value, 2); }
  OctetWriter& u32(std::uint32_t value) { return number(value, 4); }
  OctetWriter& i32(std::int32_t value) { return number(static_cast<std::uint32_t>(value), 4); }
  OctetWriter& f32(float value) { return number(std::bit_cast<std::uint32_t>(value), 4); }
  OctetWriter& f64(double value) { return number(std::bit_cast<std::uint64_t>(value), 8); }
  OctetWriter& text(std::string_view text) {
    octets_ += text;
    return *this;
  }
  OctetWriter& zeros(std::size_t count) {
    octets_.append(count, '\0');
    return *this;
  }
  const std::string& octets() const { return octets_; }

 private:
  OctetWriter& number(std::uint64_t value, int octets) {
    for (int i = 0; i < octets; ++i) {
      const int place = order_ == ByteOrder::little ? i : octets - 1 - i;
      octets_ += static_cast<char>(value >> (8 * place) & 0xff);
    }
    return *this;
  }

  ByteOrder order_;
  std::string octets_;
};

class OctetReader {
 public:
  // The octets outlive it.
  OctetReader(std::string_view octets, ByteOrder order) : octets_(octets), order_(order) {}
  std::uint8_t u8() { return static_cast<std::uint8_t>(number(1)); }
  std::uint16_t u16() { return static_cast<std::uint16_t>(number(2)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
  std::int32_t i32() { return static_cast<std::int32_t>(number(4)); }
  float f32() { return std::bit_cast<float>(static_cast<std::uint32_t>(number(4))); }
  double f64() { return std::bit_cast<double>(number(8)); }
  // Fewer where so many are not left.
  std::string_view text(std::size_t count) {
    sound_ = sound_ && count <= octets_.size();
    const std::string_view taken = octets_.substr(0, count);
    octets_.remove_prefix(taken.size());
    return taken;
  }
  std::string_view rest() { return text(octets_.size()); }

  std::size_t left() const { return octets_.size(); }
  bool sound() const { return sound_; }
  bool whole() const { return sound_ && octets_.empty(); }

 private:
  std::uint64_t number(std::size_t octets) {
    const std::string_view taken = text(octets);
    if (taken.size() < octets) return 0;
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < octets; ++i) {
      const std::size_t place = order_ == ByteOrder::big ? i : octets - 1 - i;
      value = value << 8 | static_cast<unsigned char>(taken[place]);
    }
    return value;
  }

  std::string_view octets_;
  ByteOrder order_;
  bool sound_ = true;
};

}  // namespace pizarra::line
