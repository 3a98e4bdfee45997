// The instantiation of a scheme's terms.
#pragma once

#include "sph/compiled_terms.hpp"
#include "sph/schemes.hpp"

// Compiles the terms of a scheme. Schemes with the same terms are listed once.
#define SLOSH_COMPILE(CHOICE) \
  template std::shared_ptr<const SchemeTerms> compiled(const PairTermsOf<CHOICE>& terms)
