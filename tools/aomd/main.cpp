// The program `aomd`.

#include "tools/aomd/program.h"

int main(int argc, char** argv) {
  using namespace aomd::cli;
  const std::vector<AddCommand> commands{add_info,    add_decimate,  add_check,  add_classify,
                                         add_convert, add_compare,   add_repair, add_replay,
                                         add_sample,  add_image_diff};
  return run_program("aomd", commands, argc, argv);
}
