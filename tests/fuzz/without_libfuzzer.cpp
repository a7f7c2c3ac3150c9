// Runs a fuzz target without libFuzzer, for the tests: everything in its corpus, then as many damaged inputs as asked
// for, the same for the same seed.
//
//   fuzz_reader_test CORPUS-FOLDER INPUTS

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "blackboard/time/random.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using pizarra::Random;

constexpr std::size_t longest = 4096;

void run(const std::string& input) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

std::string damaged(std::string text, const std::vector<std::string>& corpus, Random& random) {
  for (std::uint64_t edits = 1 + random.below(6); edits > 0; --edits) {
    const std::size_t at = random.below(text.size() + 1);
    switch (random.below(4)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        text.erase(at, 1 + random.below(12));
        break;
      case 2: {
        const std::string& other = corpus[random.below(corpus.size())];
        text.insert(at, other.substr(random.below(other.size() + 1), random.below(40)));
        break;
      }
      default:
        text.insert(at, std::string(1 + random.below(70), "()\" 9-?"[random.below(7)]));
    }
  }
  text.resize(std::min(text.size(), longest));
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<std::string> corpus;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  if (corpus.empty()) return 2;
  for (const std::string& input : corpus) run(input);
  constexpr std::uint64_t seed = 1;
  std::printf("seed %d\n", static_cast<int>(seed));
  Random random(seed);
  const long inputs = std::strtol(argv[2], nullptr, 10);
  for (long i = 0; i < inputs; ++i) run(damaged(corpus[random.below(corpus.size())], corpus, random));
  std::printf("%zu inputs of the corpus and %ld damaged ones did no harm\n", corpus.size(), inputs);
}
