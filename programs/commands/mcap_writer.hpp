#pragma once

// A file in the MCAP format (mcap.dev): channels of JSON messages, in chunks with an index, so that a reader finds a
// time without reading everything. Nothing is compressed.
//
//   Result<std::unique_ptr<McapWriter>> file = McapWriter::create("run.mcap");
//   const std::uint16_t story = (*file)->add_channel("/story", "foxglove.Log", schema);
//   (*file)->write(story, when, "{...}");
//   Result<void> written = (*file)->close();           // what could not be written is said here

#include <cstdint>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "blackboard/time/clock.hpp"
#include "lisp/result.hpp"

namespace pizarra::programs {

class McapWriter {
 public:
  // Failure: unwritable-file.
  static Result<std::unique_ptr<McapWriter>> create(const std::string& path);

  std::uint16_t add_channel(std::string_view topic, std::string_view schema_name, std::string_view schema);
  void write(std::uint16_t channel, Time when, std::string_view message);
  std::uint64_t messages() const { return messages_; }
  Result<void> close();

 private:
  static constexpr std::size_t chunk_bytes = 1 << 20;
  struct Extent {
    std::uint64_t begin = UINT64_MAX;
    std::uint64_t end = 0;
    void add(std::uint64_t time);
  };

  explicit McapWriter(const std::string& path);
  void put(std::string_view bytes);
  void end_chunk();
  std::string message_indexes(std::map<std::uint16_t, std::uint64_t>& offsets) const;
  std::string statistics() const;

  const std::string path_;
  std::ofstream out_;
  std::uint64_t at_ = 0;
  std::string declared_;  // schemas and channels, for the summary
  std::string chunk_;
  Extent chunk_extent_;
  using Index = std::vector<std::pair<std::uint64_t, std::uint64_t>>;
  std::map<std::uint16_t, Index> chunk_index_;  // of each channel: times and places in the chunk
  std::string chunk_indexes_;                   // of all chunks, for the summary
  std::uint32_t chunks_ = 0;
  std::uint64_t messages_ = 0;
  Extent extent_;
  std::map<std::uint16_t, std::uint64_t> counts_;  // of each channel
};

}  // namespace pizarra::programs
