// aomd image-diff: whether one picture is another one, by the verdict of aomd-view --compare.

#include <iostream>
#include <memory>

#include "core/measure/image_diff.h"
#include "core/measure/picture_verdict.h"
#include "tools/aomd/command.h"
#include "tools/aomd/outputs.h"
#include "tools/aomd/values.h"

namespace aomd::cli {
namespace {

struct ImageDiffArguments {
  std::string a, b, output;
  double threshold = measure::PictureLimits().threshold;
};

int run(const ImageDiffArguments& options) {
  check_files({{"A", options.a}, {"B", options.b}}, {{"--output", options.output}});
  const io::Image a = io::read_png(options.a), b = io::read_png(options.b);
  const measure::ImageDifference difference = measure::compare_images(a, b);
  if (!options.output.empty()) io::write_png(options.output, measure::difference_picture(a, b));
  if (!difference.same_size)
    std::cout << "sizes differ: " << a.width << "x" << a.height << " and " << b.width << "x"
              << b.height << '\n';
  std::cout << "ssim " << difference.ssim << ", " << difference.differing_pixels << " of "
            << difference.pixels << " pixels differ, by " << difference.largest_channel_difference
            << " of 255 at most\n";
  const measure::PictureVerdict verdict =
      measure::judge_pictures(a, b, measure::PictureLimits::with_threshold(options.threshold));
  std::cout << (verdict.same ? "the same picture" : "another picture: " + verdict.why) << '\n';
  return verdict.same ? done : says_no;
}

}  // namespace

void add_image_diff(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("image-diff", "Compares two PNG pictures; exit code 1 when they differ");
  const auto options = std::make_shared<ImageDiffArguments>();
  command->add_option("A", options->a, "A picture")->required();
  command->add_option("B", options->b, "The other one")->required();
  command
      ->add_option("--threshold", options->threshold,
                   "Structural similarity that each tile of 32x32 pixels must have; with 1 nothing "
                   "is forgiven")
      ->type_name("S")
      ->check(between(0, 1))
      ->capture_default_str();
  command->add_option("--output", options->output, "Writes a picture of the differences, in red");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace aomd::cli
