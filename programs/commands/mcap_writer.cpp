#include "programs/commands/mcap_writer.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <zlib.h>

namespace pizarra::programs {

namespace {

constexpr std::string_view magic("\x89MCAP0\r\n", 8);

enum class Op : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  statistics = 0x0B,
  data_end = 0x0F,
};

// Little-endian, as everything in the format.
template <typename Integer>
std::string number(Integer value) {
  std::string out;
  for (std::size_t i = 0; i < sizeof value; ++i) out += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i));
  return out;
}

std::string text(std::string_view bytes) { return number(static_cast<std::uint32_t>(bytes.size())).append(bytes); }

std::string record(Op op, std::string_view content) {
  return (static_cast<char>(op) + number(static_cast<std::uint64_t>(content.size()))).append(content);
}

std::string pairs(const std::map<std::uint16_t, std::uint64_t>& values) {
  std::string out;
  for (const auto& [channel, value] : values) out += number(channel) + number(value);
  return text(out);
}

std::uint64_t nanoseconds(Time when) {
  return static_cast<std::uint64_t>(std::max<std::int64_t>(0, when.time_since_epoch().count())) * 1000;
}

}  // namespace

void McapWriter::Extent::add(std::uint64_t time) {
  begin = std::min(begin, time);
  end = std::max(end, time);
}

Result<std::unique_ptr<McapWriter>> McapWriter::create(const std::string& path) {
  std::unique_ptr<McapWriter> writer(new McapWriter(path));
  if (!writer->out_) return fail("unwritable-file", fmt::format("{} cannot be written", path));
  writer->put(magic);
  writer->put(record(Op::header, text("") + text("pizarra")));
  return writer;
}

McapWriter::McapWriter(const std::string& path) : path_(path), out_(path, std::ios::binary) {}

void McapWriter::put(std::string_view bytes) {
  out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  at_ += bytes.size();
}

std::uint16_t McapWriter::add_channel(std::string_view topic, std::string_view schema_name, std::string_view schema) {
  // A channel's number is its schema's, too; 0 is none.
  const auto id = static_cast<std::uint16_t>(counts_.size() + 1);
  counts_[id] = 0;
  const std::string both =
      record(Op::schema, number(id) + text(schema_name) + text("jsonschema") + text(schema)) +
      record(Op::channel, number(id) + number(id) + text(topic) + text("json") + number(std::uint32_t{0}));
  declared_ += both;
  put(both);
  return id;
}

void McapWriter::write(std::uint16_t channel, Time when, std::string_view message) {
  const std::uint64_t time = nanoseconds(when);
  chunk_index_[channel].emplace_back(time, chunk_.size());
  const auto sequence = static_cast<std::uint32_t>(counts_[channel]++);
  chunk_ += record(Op::message, (number(channel) + number(sequence) + number(time) + number(time)).append(message));
  chunk_extent_.add(time);
  extent_.add(time);
  ++messages_;
  if (chunk_.size() >= chunk_bytes) end_chunk();
}

std::string McapWriter::message_indexes(std::map<std::uint16_t, std::uint64_t>& offsets) const {
  std::string out;
  for (const auto& [channel, index] : chunk_index_) {
    offsets[channel] = at_ + out.size();
    std::string entries;
    for (const auto& [time, offset] : index) entries += number(time) + number(offset);
    out += record(Op::message_index, number(channel) + text(entries));
  }
  return out;
}

void McapWriter::end_chunk() {
  if (chunk_.empty()) return;
  const std::uint64_t begin = at_;
  const auto size = static_cast<std::uint64_t>(chunk_.size());
  const auto checksum =
      static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(chunk_.data()), static_cast<uInt>(size)));
  const std::string times = number(chunk_extent_.begin) + number(chunk_extent_.end);
  put(record(Op::chunk, (times + number(size) + number(checksum) + text("") + number(size)).append(chunk_)));
  const std::uint64_t length = at_ - begin;
  std::map<std::uint16_t, std::uint64_t> offsets;
  const std::string indexes = message_indexes(offsets);
  put(indexes);
  chunk_indexes_ += record(Op::chunk_index, times + number(begin) + number(length) + pairs(offsets) +
                                                number(static_cast<std::uint64_t>(indexes.size())) + text("") +
                                                number(size) + number(size));
  ++chunks_;
  chunk_.clear();
  chunk_index_.clear();
  chunk_extent_ = {};
}

std::string McapWriter::statistics() const {
  const auto channels = static_cast<std::uint32_t>(counts_.size());
  const std::uint64_t begin = messages_ == 0 ? 0 : extent_.begin;
  return record(Op::statistics, number(messages_) + number(static_cast<std::uint16_t>(channels)) + number(channels) +
                                    number(std::uint32_t{0}) + number(std::uint32_t{0}) + number(chunks_) +
                                    number(begin) + number(extent_.end) + pairs(counts_));
}

Result<void> McapWriter::close() {
  end_chunk();
  put(record(Op::data_end, number(std::uint32_t{0})));
  const std::uint64_t summary = at_;
  put(declared_ + chunk_indexes_ + statistics());
  put(record(Op::footer, number(summary) + number(std::uint64_t{0}) + number(std::uint32_t{0})));
  put(magic);
  out_.close();
  if (!out_) return fail("unwritable-file", fmt::format("{} cannot be written to its end", path_));
  return {};
}

}  // namespace pizarra::programs
