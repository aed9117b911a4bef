#pragma once

namespace relievo {

enum class Method {
  approximate,  ///< inflation, then order [P §3.2]
  nonlinear,    ///< both at once [P §3.1]
};

/// Options of a build; docs/method.md explains the numbers.
struct BuildOptions {
  Method method = Method::approximate;
  int vertices = 40000;      ///< approximate number in the mesh, if `edge` is 0
  double edge = 0;           ///< length of edges along outlines, px; 0: by `vertices`
  double alpha0 = 0;         ///< alpha at a join's end [P eq 9], in [0, 1)
  double rho = 0.25;         ///< length scale of a ramp, of the ramp's length; > 0
  double lambda_bnd = 0.01;  ///< of the non-linear method: weight of outlines beside joins
  double lambda_shift = 1;   ///< of the non-linear method: weight of shifts
  bool glue = true;          ///< whether outlines beside joins lie on the lower surface
  bool attach = true;        ///< whether they begin at its height and come loose gradually
};

}  // namespace relievo
