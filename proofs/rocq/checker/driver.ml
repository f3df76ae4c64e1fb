(* Reads loops, one a line, and writes the verdict of the proved checker for each.

   A line is words divided by blanks. An interval is two rationals `n/d:n/d`, `-` stands for what is
   absent (no bound on the speed: every speed), k is a whole number, and a response is `c0,c1,...`.

     box b c K T D B F k V         with intervals
     damped b c K T D F V k B      with intervals for b and c, and numbers: delay and damping together
     filter b c K T D F V k c0,... the same under a controller, k samples late
     gated b c K T D F V k c0,...  and where the wall is one-sided or saturated
     one_pole b c K T D F V B tau  damping behind a filter with the time constant tau
     latency b c K T D F V k f c0,...  a controller's force k + f samples late
     lag b c K T D F V k f Ta c0,...   and at an amplifier with the time constant Ta *)

open Checker

let rec positive_of n = (* n > 0; digits only, the bounded numbers are made of them *)
  if n = 1 then XH else if n land 1 = 0 then XO (positive_of (n / 2)) else XI (positive_of (n / 2))

let z_of n = if n = 0 then Z0 else if n > 0 then Zpos (positive_of n) else Zneg (positive_of (-n))
let ten = z_of 10

(* A whole number of any size. *)
let whole text =
  let negative = String.length text > 0 && text.[0] = '-' in
  let digits = if negative then String.sub text 1 (String.length text - 1) else text in
  if digits = "" then failwith ("`" ^ text ^ "` is no whole number");
  let step acc digit =
    if digit < '0' || digit > '9' then failwith ("`" ^ text ^ "` is no whole number");
    Z.add (Z.mul acc ten) (z_of (Char.code digit - Char.code '0')) in
  let size = Seq.fold_left step Z0 (String.to_seq digits) in
  if negative then Z.mul (z_of (-1)) size else size

let rational text =
  match String.split_on_char '/' text with
  | [n] -> { qnum = whole n; qden = XH }
  | [n; d] ->
    (match whole d with
     | Zpos d -> { qnum = whole n; qden = d }
     | Z0 | Zneg _ -> failwith ("`" ^ text ^ "` has a denominator that is not above zero"))
  | _ -> failwith ("`" ^ text ^ "` is no rational number")

let range text =
  match String.split_on_char ':' text with
  | [lo; hi] -> { lo = rational lo; hi = rational hi }
  | _ -> failwith ("`" ^ text ^ "` is no interval")

let optional value text = if text = "-" then None else Some (value text)

let response text = List.map rational (String.split_on_char ',' text)

let rec nat_of n = if n = 0 then O else S (nat_of (n - 1))
let samples text = nat_of (int_of_string text)

let of_verdict = function Holds -> "holds" | Fails -> "fails" | Depends -> "depends"

let of_outcome = function
  | Says verdict -> of_verdict verdict
  | Unknown -> "unknown"
  | Invalid -> "invalid"

let verdict line =
  match String.split_on_char ' ' line with
  | ["box"; b; c; k; t; d; damping; force; delay; v] ->
    let box = { p_b = optional range b; p_c = optional range c; p_K = range k; p_T = range t;
                p_D = optional range d; p_B = optional range damping; p_F = optional range force;
                p_k = samples delay } in
    let speeds = match optional range v with None -> AtAll | Some v -> UpTo v in
    (match check box speeds with Some verdict -> of_verdict verdict | None -> "invalid")
  | kind :: b :: c :: k :: t :: d :: force :: v :: others ->
    let of_loop = { l_b = range b; l_c = range c; l_K = rational k; l_T = rational t;
                    l_D = optional rational d; l_F = optional rational force;
                    l_V = optional rational v } in
    of_outcome (match kind, others with
      | "damped", [delay; damping] -> check_damped of_loop (samples delay) (rational damping)
      | "filter", [delay; c] -> check_filter of_loop (late (samples delay) (response c))
      | "gated", [delay; c] -> check_gated of_loop (response c) (samples delay)
      | "one_pole", [damping; tau] -> check_one_pole of_loop (rational damping) (rational tau)
      | "latency", [delay; f; c] -> check_latency of_loop (response c) (samples delay) (rational f)
      | "lag", [delay; f; time; c] ->
        check_lag of_loop (response c) (samples delay) (rational f) (rational time)
      | _ -> failwith ("`" ^ line ^ "` is no loop"))
  | _ -> failwith ("`" ^ line ^ "` is no loop")

let () =
  try
    while true do
      print_endline (verdict (input_line stdin))
    done
  with End_of_file -> ()
