// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/io/arguments.h"
#include "bench/io/output_files.h"
#include "bench/npy/rows_file.h"
#include "bench/options/options.h"
#include "bench/output/pair_file.h"
#include "bench/spheres/sphere_formats.h"

namespace spherepair {
namespace {

void add_input(CLI::App& command, PairsOptions& options) {
  command
      .add_option("input,--input", options.input_file,
                  "File of spheres: " + describe_sphere_formats() +
                      "; or any of these by its contents from standard input (-), a pipe or <(...)")
      ->required();
  add_file_options(command, options.columns, options.decimal_comma, options.ignore_periodic);
  command.get_option("--columns")->allow_extra_args(false);  // the next word may be the input
  command.add_option("--frame", options.frame, "Frame of a file with several, counted from 0")->transform(count_range);
  auto* radius = command.add_option("--radius", options.radius, "Radius of all spheres if the file has none");
  command
      .add_option("--cutoff", options.cutoff,
                  "Find the pairs of points at most this far apart instead; radii in the file are not used")
      ->excludes(radius);
}

void add_output(CLI::App& command, PairsOptions& options) {
  auto* output = command.add_option(
      "--output", options.output_file,
      "Write the pairs i < j, sorted, in the format of the extension: .npy (m x 2, uint32), .csv (a line i,j, then a "
      "line each), .txt (a line `# i j`, then a line each), or - for those lines on standard output; in a "
      "periodic box `i j sx sy sz` with the shift of j in rows of the Lattice. Default: none, only the summary");
  auto* distances = command
                        .add_flag("--distances", options.distances,
                                  "Also write the distance of the centres of each pair, in float64: `i j distance`, "
                                  "or a structured NPY array")
                        ->needs(output);
  auto* csr = command
                  .add_flag("--csr", options.csr,
                            "Write the neighbours of each sphere, in both directions and ascending, as CSR arrays: for "
                            "--output list.npy list.offsets.npy (n + 1, uint64), list.neighbours.npy (2 m, uint32) "
                            "and, with --distances, list.distances.npy (2 m, float64)")
                  ->needs(output);
  command
      .add_flag("--geometry", options.geometry,
                "Also write the overlap, the unit normal from i to j and the contact point of each pair, in float64: "
                "`i j overlap nx ny nz px py pz`, or a structured NPY array")
      ->needs(output)
      ->excludes(distances)
      ->excludes(csr)
      ->excludes(command.get_option("--cutoff"));
  command.add_option("--contacts", options.contacts_file,
                     "Write the number of contacts of each sphere to this file: .npy (uint32), .csv, .txt or -");
  command.add_option("--json", options.json_file,
                     "Write the summary and context as JSON to this file; -: to standard output");
}

// The files that --output stands for: none, the named one, or the files of the neighbour list.
std::vector<std::string> output_files(const PairsOptions& options) {
  if (!options.csr) return {options.output_file};
  const NeighbourFiles files = neighbour_files(options.output_file, options.distances);
  return {files.offsets, files.neighbours, files.distances, files.shifts};
}

}  // namespace

void check_pairs_options(const PairsOptions& options) {
  if (!options.method.empty() && method_from_name(options.method) == Method::collide_group)
    throw std::invalid_argument("the method collide_group finds only pairs within a group; choose another");
  if (options.block) parse_blocks({options.block});
  if (options.cutoff && why_invalid(*options.cutoff, true))
    throw std::invalid_argument(
        fmt::format("--cutoff is {}, but must be within the range of float32 and not negative", *options.cutoff));
  if (options.csr && lower_extension(options.output_file) != ".npy")
    throw std::invalid_argument(fmt::format(
        "--csr writes NPY arrays, but --output is {}: give it a name that ends in .npy", options.output_file));
  OutputFiles files;
  files.read("--input", options.input_file);
  for (const std::string& file : output_files(options)) files.write("--output", file);
  files.write("--contacts", options.contacts_file);
  files.write("--json", options.json_file);
  check_pair_file("--output", options.output_file);
  check_pair_file("--contacts", options.contacts_file);
}

void add_pairs(CLI::App& app, CommandLine& line, Action& action) {
  auto* command = app.add_subcommand("pairs", "Read spheres or points from a file and find the pairs");
  auto options = std::make_shared<PairsOptions>();
  add_input(*command, *options);
  add_output(*command, *options);
  add_backend_option(*command, options->backend, "Where the pairs are searched");
  command->add_option("--method", options->method, "See run --help; default: auto");
  add_block_option(*command, options->block);
  add_verbosity_options(*command, options->verbosity);
  add_open_options(*command, line.open);
  command->footer(
      "Examples:\n  spherepair pairs spheres.npy --radius 0.5 --output pairs.npy\n"
      "  spherepair pairs points.csv --cutoff 2.5 --distances --output pairs.csv\n"
      "  spherepair pairs atoms.extxyz --output - | head");
  command->callback([=, &line, &action] { action = [=, &line] { return pairs_command(line, *options); }; });
}

}  // namespace spherepair
