# SPDX-License-Identifier: MIT
# The problems of data/reference with GNU Octave: cubic beam elements, eig, and ode15s/ode45 with events.
#
#   octave-cli beam.m PROBLEM FOLDER ELEMENTS [SOLVER RTOL ATOL]      (frequencies: [extrapolate])
1;

function [M, K0, K, b] = beam_matrices (beam, elements)
  # beam = [length, area, I, density, E, P]; u relative to the base; K with the follower force, P e_tip theta_tip
  l = beam(1) / elements; m = beam(2) * beam(4); EI = beam(3) * beam(5); P = beam(6); n = 2 * elements + 2;
  me = m*l/420 * [156 22*l 54 -13*l; 22*l 4*l^2 13*l -3*l^2; 54 13*l 156 -22*l; -13*l -3*l^2 -22*l 4*l^2];
  ke = EI/l^3 * [12 6*l -12 6*l; 6*l 4*l^2 -6*l 2*l^2; -12 -6*l 12 -6*l; 6*l 2*l^2 -6*l 4*l^2];
  ge = 1/(30*l) * [36 3*l -36 3*l; 3*l 4*l^2 -3*l -l^2; -36 -3*l 36 -3*l; 3*l -l^2 -3*l 4*l^2];
  M = K0 = G = zeros (n); b = zeros (n, 1);
  for e = 1:elements
    s = 2*e-1 : 2*e+2;
    M(s,s) += me; K0(s,s) += ke; G(s,s) += ge; b(s) += m * [l/2; l^2/12; l/2; -l^2/12];
  endfor
  M = M(3:n,3:n); K0 = K0(3:n,3:n); b = b(3:n);
  K = K0 - P * G(3:n,3:n);
  K(n-3,n-2) += P;
endfunction

function f = frequencies (beam, elements, state, inverse)
  [M, ~, K, ~] = beam_matrices (beam, elements);
  free = 1:columns (M);
  if (strcmp (state, "stick"))
    free(end-1) = [];
  endif
  if (inverse)  # as 1/omega^2: rounding then spares the lowest frequencies
    squares = sort (1 ./ real (eig (M(free,free), K(free,free))));
  else
    squares = sort (real (eig (K(free,free), M(free,free))));
  endif
  f = sqrt (squares(1:10)) / (2*pi);
endfunction

function varargout = leave_or_stop (value)
  varargout = {value, 1, -1};  # stop where the value falls through zero
endfunction

function [samples, events] = history (problem, beam, elements, solver, rtol, atol)
  # Phase by phase; samples: time, stick (1) or slip (0), y at midspan, y at the tip, friction force -f_d
  held = strcmp (problem, "stick-history"); damped = strncmp (problem, "stick-slip", 10);
  hz = ifelse_ (held, 15, 25); A0 = ifelse_ (held, 0.5e-3, 1e-3); eta = ifelse_ (damped, 6.4e-5, 0);
  grid = ifelse_ (held, (0:1000) * 1e-3, ifelse_ (damped, (0:2500) * 2e-4, (0:1000) * 5e-4));
  omega = 2*pi*hz; P = beam(6);
  [M, K0, K, b] = beam_matrices (beam, elements);
  n = columns (M); tip = n - 1; middle = elements - 1; others = setdiff (1:n, tip);
  h = @(t) A0 * sin (omega*t); h1 = @(t) A0 * omega * cos (omega*t); h2 = @(t) -A0 * omega^2 * sin (omega*t);
  mu_P = @(v) P * (0.3 + 0.3 * exp (-abs (v)));
  slip = [zeros(n), eye(n); -(M \ K), -(M \ (eta * K0))];
  slip_base = [zeros(n,1); -(M \ b)]; slip_tip = [zeros(n,1); M \ ((1:n)' == tip)]; row = n + tip;
  reaction_row = -slip(row,:) / slip_tip(row);  # f_d gives the held tip the acceleration -h''
  reaction_base = (-1 - slip_base(row)) / slip_tip(row);
  reaction = @(t, x) reaction_row * x + reaction_base * h2 (t);
  stick = slip + slip_tip * reaction_row; stick_base = slip_base + slip_tip * reaction_base;
  S = zeros (n, 1); S(tip) = -1; S(others) = K(others,others) \ K(others,tip);
  x = [zeros(n,1); S * h1(0)]; t = 0; direction = 0; samples = zeros (0, 5); events = zeros (0, 3);
  solve = str2func (solver);
  while (t < grid(end) - 1e-12)
    if (direction == 0)
      rate = @(t, x) stick * x + stick_base * h2 (t); jacobian = stick;
      event = @(t, x) leave_or_stop (ifelse_ (held, 1, mu_P (0) - abs (reaction (t, x))));
    else
      rate = @(t, x) slip * x + slip_base * h2 (t) - slip_tip * direction * mu_P (x(row) + h1 (t)); jacobian = slip;
      event = @(t, x) leave_or_stop (direction * (x(row) + h1 (t)));
    endif
    options = odeset ("RelTol", rtol, "AbsTol", atol, "Events", event);
    if (strcmp (solver, "ode15s"))
      options = odeset (options, "Jacobian", jacobian);
    endif
    wanted = grid(grid > t + 1e-12);
    run = solve (rate, [t, wanted](:), x, options);
    ended = ! isempty (run.ie);
    times = run.x(:)'; states = run.y; if (columns (states) != numel (times)) states = states'; endif
    last = ifelse_ (ended, min ([run.xe(:); Inf]), Inf);  # a sample behind the event belongs to the next phase
    for k = find (ismember (times, wanted) & times < last)
      y = states(:,k); f = ifelse_ (direction == 0, -reaction (times(k), y), direction * mu_P (y(row) + h1 (times(k))));
      samples(end+1,:) = [times(k), direction == 0, h(times(k)) + y(middle), h(times(k)) + y(tip), f];
    endfor
    if (! ended)
      break
    endif
    t = run.xe(end); x = run.ye; x = reshape (x', [], numel (run.xe))(:,end);
    f_d = reaction (t, x); before = direction;
    if (before != 0 && abs (f_d) < mu_P (0))
      direction = 0;
    else
      direction = -sign (f_d);
    endif
    if ((before == 0) != (direction == 0))
      events(end+1,:) = [t, direction == 0, h(t) + x(tip)];
    endif
  endwhile
endfunction

function value = ifelse_ (condition, yes, no)
  if (condition) value = yes; else value = no; endif
endfunction

function power = slider_power (a, solver, rtol, atol)
  # SDND104; x = [sliding velocity; work of 10 N |v| since 4 s]
  t = 0; x = [0; 0]; direction = 0; solve = str2func (solver);
  while (a > 1 && t < 12)
    if (direction == 0)
      if (abs (a * sin (2*pi*t)) <= 1)  # it sticks until the inertia force exceeds 1 N
        onset = asin (1/a) / (2*pi); t = onset + ceil (2 * (t - onset)) / 2;
      endif
      direction = -sign (sin (2*pi*t));
      if (t >= 12) break; endif
    endif
    stop = ifelse_ (t < 4, 4, 12);
    options = odeset ("RelTol", rtol, "AbsTol", atol, "Events", @(t, x) leave_or_stop (direction * x(1)));
    run = solve (@(t, x) [-a*sin(2*pi*t) - direction; (t >= 4) * 10 * abs(x(1))], [t, stop], x, options);
    if (isempty (run.ie))
      t = stop; states = run.y; if (rows (states) != 2) states = states'; endif
      x = states(:,end);
    else
      t = run.xe(end); x = reshape (run.ye', 2, [])(:,end); x(1) = 0; direction = 0;
    endif
  endwhile
  power = x(2) / 8;
endfunction

given = argv (); problem = given{1}; folder = given{2}; elements = str2double (given{3});
lines = strsplit (strtrim (fileread ("/data/reference/beams.csv")), "\n"); names = {}; beams = [];
for i = 2:numel (lines)
  words = strsplit (lines{i}, ","); names{end+1} = words{1}; beams(end+1,:) = str2double (words(2:7));
endfor
file = fopen ([folder "/result.csv"], "w");
if (any (strcmp (problem, {"stick-frequencies", "slip-frequencies"})))
  fprintf (file, "beam,mode,frequency\n"); extrapolate = numel (given) > 3; state = strtok (problem, "-");
  asked = regexp (fileread (["/data/reference/frequencies/" state ".csv"]), "^[a-z-]+(?=,)", "match", "lineanchors");
  for i = find (ismember (names, asked))
    f = frequencies (beams(i,:), elements, state, extrapolate);
    if (extrapolate)  # the error falls with the fourth power of the element length
      f += (f - frequencies (beams(i,:), elements/2, state, true)) / 15;
    endif
    for k = 1:10 fprintf (file, "%s,%d,%.15g\n", names{i}, k, f(k)); endfor
  endfor
elseif (strcmp (problem, "friction-powers"))
  fprintf (file, "amplitude,power\n");
  for a = [0.99, 1.01, 1.5, 15]
    fprintf (file, "%g,%.15g\n", a, slider_power (a, given{4}, str2double (given{5}), str2double (given{6})));
  endfor
else
  [samples, events] = history (problem, beams(strcmp (names, "paper"),:), elements, given{4}, ...
                               str2double (given{5}), str2double (given{6}));
  phases = {"slip", "stick"}; changes = {"onset", "capture"};
  fprintf (file, "time,phase,midspan_displacement,tip_displacement,friction_force\n");
  for s = samples' fprintf (file, "%.10g,%s,%.15g,%.15g,%.12g\n", s(1), phases{1+s(2)}, s(3:5)); endfor
  if (strncmp (problem, "stick-slip", 10))
    short = find (events(1:end-1,2) == 1 & diff (events(:,1)) < 2e-5); events([short; short+1],:) = [];  # count as slip
    out = fopen ([folder "/events.csv"], "w"); fprintf (out, "time,change,position\n");
    for e = events' fprintf (out, "%.12g,%s,%.12g\n", e(1), changes{1+e(2)}, e(3)); endfor
    fclose (out);
  endif
endif
fclose (file);
