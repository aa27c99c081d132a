// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The one place that knows every method.
#include "core/front_end.hpp"
#include "methods/ct_icp/ct_icp_front_end.hpp"
#include "methods/floam/floam_front_end.hpp"
#include "methods/genz_icp/genz_icp_front_end.hpp"
#include "methods/icp/icp_front_end.hpp"
#include "methods/kiss_icp/kiss_icp_front_end.hpp"
#include "methods/knots/knot_front_end.hpp"
#include "methods/paper/paper_front_end.hpp"

namespace surefoot {

std::unique_ptr<FrontEnd> make_front_end(const Session& session) {
  switch (session.config.method) {
    case Method::surefoot:
      return std::make_unique<KnotFrontEnd>(session);
    case Method::kiss_icp:
      return std::make_unique<KissIcpFrontEnd>(session);
    case Method::icp:
      return std::make_unique<IcpFrontEnd>(session);
    case Method::genz_icp:
      return std::make_unique<GenzIcpFrontEnd>(session);
    case Method::floam:
      return std::make_unique<FloamFrontEnd>(session);
    case Method::ct_icp:
      return std::make_unique<CtIcpFrontEnd>(session);
    case Method::paper:
      break;
  }
  return std::make_unique<PaperFrontEnd>(session);
}

}  // namespace surefoot
