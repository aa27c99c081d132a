// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/registry.hpp"

#include "config/method.hpp"
#include "core/front_end.hpp"

namespace surefoot {

std::span<const Method* const> registered_methods() {
  static const Method* const methods[] = {
      &knots_method(),    &paper_method(), &kiss_icp_method(), &icp_method(),
      &genz_icp_method(), &floam_method(), &ct_icp_method(),
  };
  return methods;
}

std::vector<std::span<const ConfigField>> field_tables() {
  // A scan's way from its points to its health, whichever of our own two registers it; then the
  // systems to compare with.
  std::vector<std::span<const ConfigField>> tables = {input_fields(), paper_method().fields,
                                                      knots_method().fields, health_fields()};
  for (const Method* method : registered_methods().subspan(2)) tables.push_back(method->fields);
  return tables;
}

std::unique_ptr<FrontEnd> make_front_end(const Session& session) {
  return find_method(session.config.method).make_front_end(session);
}

}  // namespace surefoot
