// SPDX-License-Identifier: MIT
// Histories of data/reference with CVODE: BDF, Newton with a dense Jacobian, stick and slip separated by root finding.
//
//   beam PROBLEM FOLDER ELEMENTS RTOL ATOL
//
// State x = (q, v): deflection and rotation of the nodes relative to the base, and their rates. M a + C v + K q =
// -b h'' + e_tip f_d holds in stick and in slip; K has the follower force, P e_tip theta_tip.
#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

enum { largest = 200 };
static const double length = 2.0, mass = 10.0, rigidity = 2e9 / 120000.0, axial = 500.0;
static double hz, amplitude, eta;
static int size, tip, direction, held_for_ever;
static double slip[largest][2 * largest], stick[largest][2 * largest];         // a = slip (q, v) + ...
static double slip_base[largest], stick_base[largest], slip_tip[largest];      // ... base h'' + tip f_d
static double reaction_row[2 * largest], reaction_base, start[largest];
static double slider_amplitude;

static void check(int flag, const char* what) {
  if (flag < 0) {
    fprintf(stderr, "beam: %s returned %d\n", what, flag);
    exit(1);
  }
}

static double base(double t, int derivative) {
  const double omega = 2 * M_PI * hz;
  return amplitude * pow(omega, derivative) * sin(omega * t + derivative * M_PI / 2);
}

static double friction(double v) { return axial * (0.3 + 0.3 * exp(-fabs(v))); }

// Gaussian elimination with pivoting: x becomes A^-1 x, a column each.
static void solve(int n, double a[largest][largest], int columns, double x[largest][2 * largest]) {
  for (int k = 0; k < n; ++k) {
    int p = k;
    for (int i = k; i < n; ++i)
      if (fabs(a[i][k]) > fabs(a[p][k])) p = i;
    for (int j = 0; j < n; ++j) { const double s = a[k][j]; a[k][j] = a[p][j]; a[p][j] = s; }
    for (int j = 0; j < columns; ++j) { const double s = x[k][j]; x[k][j] = x[p][j]; x[p][j] = s; }
    for (int i = 0; i < n; ++i) {
      const double f = i == k ? 0 : a[i][k] / a[k][k];
      if (f == 0) continue;
      for (int j = k; j < n; ++j) a[i][j] -= f * a[k][j];
      for (int j = 0; j < columns; ++j) x[i][j] -= f * x[k][j];
    }
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < columns; ++j) x[i][j] /= a[i][i];
}

static void assemble(int elements) {
  static double m[largest + 2][largest + 2], k[largest + 2][largest + 2], g[largest + 2][largest + 2], b[largest + 2];
  static double inertia[largest][largest], copy[largest][largest], held[largest][largest];
  static double columns[largest][2 * largest], shape[largest][2 * largest];
  const double l = length / elements;
  const double me[4][4] = {{156, 22 * l, 54, -13 * l}, {22 * l, 4 * l * l, 13 * l, -3 * l * l},
                           {54, 13 * l, 156, -22 * l}, {-13 * l, -3 * l * l, -22 * l, 4 * l * l}};
  const double ke[4][4] = {{12, 6 * l, -12, 6 * l}, {6 * l, 4 * l * l, -6 * l, 2 * l * l},
                           {-12, -6 * l, 12, -6 * l}, {6 * l, 2 * l * l, -6 * l, 4 * l * l}};
  const double ge[4][4] = {{36, 3 * l, -36, 3 * l}, {3 * l, 4 * l * l, -3 * l, -l * l},
                           {-36, -3 * l, 36, -3 * l}, {3 * l, -l * l, -3 * l, 4 * l * l}};
  const double be[4] = {l / 2, l * l / 12, l / 2, -l * l / 12};
  for (int e = 0; e < elements; ++e)
    for (int i = 0; i < 4; ++i) {
      b[2 * e + i] += mass * be[i];
      for (int j = 0; j < 4; ++j) {
        m[2 * e + i][2 * e + j] += mass * l / 420 * me[i][j];
        k[2 * e + i][2 * e + j] += rigidity / (l * l * l) * ke[i][j];
        g[2 * e + i][2 * e + j] += ge[i][j] / (30 * l);
      }
    }
  size = 2 * elements;
  tip = size - 2;
  for (int i = 0; i < size; ++i) {  // a = -M^-1 (K q + C v); the clamped node is left out
    for (int j = 0; j < size; ++j) {
      inertia[i][j] = copy[i][j] = m[i + 2][j + 2];
      slip[i][j] = -(k[i + 2][j + 2] - axial * g[i + 2][j + 2] + (i == tip && j == tip + 1 ? axial : 0));
      held[i][j] = i == tip || j == tip ? (i == j) : -slip[i][j];
      slip[i][size + j] = -eta * k[i + 2][j + 2];
    }
    columns[i][0] = -b[i + 2], columns[i][1] = i == tip;
    shape[i][0] = i == tip ? -1 : -slip[i][tip];
  }
  solve(size, inertia, 2 * size, slip);
  solve(size, copy, 2, columns);
  solve(size, held, 1, shape);  // static shape S, S(L) = -1
  for (int i = 0; i < size; ++i) slip_base[i] = columns[i][0], slip_tip[i] = columns[i][1], start[i] = shape[i][0];
  // In stick f_d gives the tip the acceleration -h''.
  for (int j = 0; j < 2 * size; ++j) reaction_row[j] = -slip[tip][j] / slip_tip[tip];
  reaction_base = (-1 - slip_base[tip]) / slip_tip[tip];
  for (int i = 0; i < size; ++i) {
    stick_base[i] = slip_base[i] + slip_tip[i] * reaction_base;
    for (int j = 0; j < 2 * size; ++j) stick[i][j] = slip[i][j] + slip_tip[i] * reaction_row[j];
  }
}

static double reaction(double t, const double* x) {
  double force = reaction_base * base(t, 2);
  for (int j = 0; j < 2 * size; ++j) force += reaction_row[j] * x[j];
  return force;
}

static double sliding(double t, const double* x) { return x[size + tip] + base(t, 1); }

static int beam_rate(double t, N_Vector state, N_Vector rate, void* data) {
  (void)data;
  const double *x = N_VGetArrayPointer(state), h2 = base(t, 2);
  double* r = N_VGetArrayPointer(rate);
  const double force = direction == 0 ? 0 : -direction * friction(sliding(t, x));
  for (int i = 0; i < size; ++i) {
    const double* row = direction == 0 ? stick[i] : slip[i];
    double a = (direction == 0 ? stick_base[i] : slip_base[i]) * h2 + (direction == 0 ? 0 : slip_tip[i] * force);
    for (int j = 0; j < 2 * size; ++j) a += row[j] * x[j];
    r[i] = x[size + i];
    r[size + i] = a;
  }
  return 0;
}

static int beam_jacobian(double t, N_Vector state, N_Vector rate, SUNMatrix jacobian, void* data, N_Vector a, N_Vector b,
                         N_Vector c) {
  (void)t, (void)state, (void)rate, (void)data, (void)a, (void)b, (void)c;
  for (int i = 0; i < size; ++i) {
    SM_ELEMENT_D(jacobian, i, size + i) = 1;
    for (int j = 0; j < 2 * size; ++j) SM_ELEMENT_D(jacobian, size + i, j) = direction == 0 ? stick[i][j] : slip[i][j];
  }
  return 0;
}

static int beam_root(double t, N_Vector state, double* g, void* data) {
  (void)data;
  const double* x = N_VGetArrayPointer(state);
  g[0] = direction != 0 ? direction * sliding(t, x) : held_for_ever ? 1 : friction(0) - fabs(reaction(t, x));
  return 0;
}

static int slider_rate(double t, N_Vector state, N_Vector rate, void* data) {
  (void)data;
  const double v = N_VGetArrayPointer(state)[0];
  N_VGetArrayPointer(rate)[0] = -slider_amplitude * sin(2 * M_PI * t) - direction;
  N_VGetArrayPointer(rate)[1] = t >= 4 ? 10 * direction * v : 0;
  return 0;
}

static int slider_root(double t, N_Vector state, double* g, void* data) {
  (void)t, (void)data;
  g[0] = direction * N_VGetArrayPointer(state)[0];
  return 0;
}

static void* integrator(SUNContext context, CVRhsFn rate, CVRootFn root, CVLsJacFn jacobian, N_Vector x, double rtol,
                        double atol) {
  static int falling = -1;
  void* cvode = CVodeCreate(CV_BDF, context);
  SUNMatrix matrix = SUNDenseMatrix(N_VGetLength(x), N_VGetLength(x), context);
  check(CVodeInit(cvode, rate, 0, x), "CVodeInit");
  check(CVodeSStolerances(cvode, rtol, atol), "CVodeSStolerances");
  check(CVodeSetLinearSolver(cvode, SUNLinSol_Dense(x, matrix, context), matrix), "CVodeSetLinearSolver");
  if (jacobian) check(CVodeSetJacFn(cvode, jacobian), "CVodeSetJacFn");
  check(CVodeRootInit(cvode, 1, root), "CVodeRootInit");
  check(CVodeSetRootDirection(cvode, &falling), "CVodeSetRootDirection");
  check(CVodeSetMaxNumSteps(cvode, 10000000), "CVodeSetMaxNumSteps");
  return cvode;
}

// Case SDND104; x = (sliding velocity, work of 10 N |v| since 4 s).
static void slider(const char* folder, SUNContext context, double rtol, double atol) {
  char name[4096];
  snprintf(name, sizeof name, "%s/result.csv", folder);
  FILE* file = fopen(name, "w");
  fprintf(file, "amplitude,power\n");
  const double amplitudes[] = {0.99, 1.01, 1.5, 15};
  for (int k = 0; k < 4; ++k) {
    const double a = slider_amplitude = amplitudes[k];
    double t = 0;
    N_Vector x = N_VNew_Serial(2, context);
    double* value = N_VGetArrayPointer(x);
    N_VConst(0, x);
    direction = 0;
    void* cvode = integrator(context, slider_rate, slider_root, NULL, x, rtol, atol);
    while (a > 1 && t < 12) {
      if (direction == 0) {
        if (fabs(a * sin(2 * M_PI * t)) <= 1) {  // it sticks until the inertia force exceeds 1 N
          const double onset = asin(1 / a) / (2 * M_PI);
          t = onset + ceil(2 * (t - onset)) / 2;
        }
        direction = sin(2 * M_PI * t) > 0 ? -1 : 1;
      }
      if (t >= 12) break;
      const double end = t < 4 ? 4 : 12;
      check(CVodeReInit(cvode, t, x), "CVodeReInit");
      check(CVodeSetStopTime(cvode, end), "CVodeSetStopTime");
      const int flag = CVode(cvode, end, x, &t, CV_NORMAL);
      check(flag, "CVode");
      if (flag == CV_ROOT_RETURN) value[0] = 0, direction = 0;
    }
    fprintf(file, "%g,%.17g\n", a, value[1] / 8);
  }
  fclose(file);
}

int main(int count, char** arguments) {
  if (count != 6) return fprintf(stderr, "usage: beam PROBLEM FOLDER ELEMENTS RTOL ATOL\n"), 2;
  const char *problem = arguments[1], *folder = arguments[2];
  const double rtol = atof(arguments[4]), atol = atof(arguments[5]);
  const int held = !strcmp(problem, "stick-history"), damped = !strncmp(problem, "stick-slip", 10);
  SUNContext context;
  check(SUNContext_Create(NULL, &context), "SUNContext_Create");
  if (!strcmp(problem, "friction-powers")) return slider(folder, context, rtol, atol), 0;

  hz = held ? 15 : 25, amplitude = held ? 0.5e-3 : 1e-3, eta = damped ? 6.4e-5 : 0, held_for_ever = held;
  const double sample = held ? 1e-3 : damped ? 2e-4 : 5e-4;
  const int samples = held ? 1000 : damped ? 2500 : 1000;
  assemble(atoi(arguments[3]));
  char name[4096];
  snprintf(name, sizeof name, "%s/result.csv", folder);
  FILE* file = fopen(name, "w");
  snprintf(name, sizeof name, "%s/events.csv", folder);
  FILE* events = damped ? fopen(name, "w") : NULL;
  fprintf(file, "time,phase,midspan_displacement,tip_displacement,friction_force\n");
  if (damped) fprintf(events, "time,change,position\n");

  N_Vector state = N_VNew_Serial(2 * size, context);
  double *x = N_VGetArrayPointer(state), t = 0, capture_time = -1, capture_position = 0;
  N_VConst(0, state);
  for (int i = 0; i < size; ++i) x[size + i] = start[i] * base(0, 1);
  void* cvode = integrator(context, beam_rate, beam_root, beam_jacobian, state, rtol, atol);
  for (int i = damped || held; i <= samples;) {
    const int flag = i == 0 ? 0 : CVode(cvode, i * sample, state, &t, CV_NORMAL);
    check(flag, "CVode");
    if (flag != CV_ROOT_RETURN) {
      const double force = direction == 0 ? -reaction(t, x) : direction * friction(sliding(t, x));
      fprintf(file, "%.10g,%s,%.15g,%.15g,%.12g\n", i * sample, direction == 0 ? "stick" : "slip",
              base(t, 0) + x[size / 2 - 2], base(t, 0) + x[tip], force);
      ++i;
      continue;
    }
    const double force = reaction(t, x), position = base(t, 0) + x[tip];
    const int before = direction;
    direction = before != 0 && fabs(force) < friction(0) ? 0 : force > 0 ? -1 : 1;
    if (damped && before != 0 && direction == 0) capture_time = t, capture_position = position;
    if (damped && before == 0) {  // a stick shorter than 2e-5 s counts as slip
      if (capture_time < 0) fprintf(events, "%.12g,onset,%.12g\n", t, position);
      else if (t - capture_time >= 2e-5)
        fprintf(events, "%.12g,capture,%.12g\n%.12g,onset,%.12g\n", capture_time, capture_position, t, position);
    }
    check(CVodeReInit(cvode, t, state), "CVodeReInit");
  }
  if (damped && direction == 0) fprintf(events, "%.12g,capture,%.12g\n", capture_time, capture_position);
  fclose(file);
  if (events) fclose(events);
  return 0;
}
