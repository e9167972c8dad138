#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <utility>

namespace prosector {

/// Keeps `former`, the name of `option` before it was renamed, valid for one release. The help omits it. A
/// command line that uses it prints one warning on standard error. `app` owns `option`.
inline void accept_former_name(CLI::App& app, CLI::Option& option, const std::string& former) {
  CLI::callback_t forward = [&option, former](const CLI::results_t& values) {
    fmt::print(stderr, "warning: {} is deprecated and will be removed in the next release; use {}\n", former,
               option.get_name());
    for (const std::string& value : values) option.add_result(value);
    option.run_callback();
    return true;
  };
  CLI::Option* alias = app.add_option(former, std::move(forward));
  alias->group("")->multi_option_policy(option.get_multi_option_policy());
  alias->type_size(option.get_type_size_min(), option.get_type_size_max());
  if (option.get_expected_max() == 0)
    alias->expected(0);  // a flag
  else
    alias->expected(option.get_expected_min(), option.get_expected_max());
  alias->allow_extra_args(option.get_allow_extra_args())->delimiter(option.get_delimiter());
}

}  // namespace prosector
