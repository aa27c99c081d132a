#pragma once
#include <cstdlib>
namespace surefoot { inline double env(const char* n, double d) { const char* t = std::getenv(n); return t ? std::atof(t) : d; } }
