(* Reads boxes, one a line, and writes the verdict of the proved checker for each.

   A line is b c K T D B F k V, divided by blanks: an interval of two rationals `n/d:n/d`, or `-`
   for what is absent (no bound on the speed: every speed); k is a whole number. *)

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

let optional text = if text = "-" then None else Some (range text)

let rec nat_of n = if n = 0 then O else S (nat_of (n - 1))

let verdict line =
  match String.split_on_char ' ' line with
  | [b; c; k; t; d; damping; force; delay; v] ->
    let box = { p_b = optional b; p_c = optional c; p_K = range k; p_T = range t; p_D = optional d;
                p_B = optional damping; p_F = optional force; p_k = nat_of (int_of_string delay) } in
    let speeds = match optional v with None -> AtAll | Some v -> UpTo v in
    (match check box speeds with
     | Some Holds -> "holds"
     | Some Fails -> "fails"
     | Some Depends -> "depends"
     | None -> "invalid")
  | _ -> failwith ("`" ^ line ^ "` is not nine words")

let () =
  try
    while true do
      print_endline (verdict (input_line stdin))
    done
  with End_of_file -> ()
