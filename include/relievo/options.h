#pragma once

namespace relievo {

enum class Method {
  approximate,  ///< inflation, then order [P §3.2]
  nonlinear,    ///< both at once [P §3.1]
};

/// How a relief is built; docs/method.md tells what the numbers do.
struct BuildOptions {
  Method method = Method::approximate;
  int vertices = 40000;      ///< of the mesh, roughly; where `edge` is 0
  double edge = 0;           ///< length of edges along outlines, px
  double alpha0 = 0;         ///< beside a join's end, in [0, 1)
  double rho = 0.25;         ///< length scale of a ramp / its length, > 0
  double lambda_bnd = 0.01;  ///< of the non-linear method
  double lambda_shift = 1;   ///< likewise
  bool glue = true;          ///< outlines beside joins lie on the lower surface
  bool attach = true;        ///< they begin at its height and come loose gradually
};

}  // namespace relievo
