// Runs one agent, or the simulated world.

#include "agents/launcher/agent/process_words.hpp"

int main(int argc, char** argv) { return pizarra::run_process_program({argv, static_cast<std::size_t>(argc)}, {}); }
