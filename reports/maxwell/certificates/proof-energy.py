# -*- coding: utf-8 -*-
# maxwell / energy: Poynting's theorem: what flows out, and what the currents take, is lost by the fields.
#
# Given: the definitions, the assumptions and charges.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# The program computes N from the sides and every p from what is given, as they are written below, and prints
# one 0 for each equation. It needs Python and SymPy. Whoever changes a side gets another number, and exit code 1.
# A function is replaced by polynomials in variables that stand for cosines, sines, exponentials, roots; that
# each replacement is right is looked up at random numbers, to 40 digits.

import ast
import random
import sys

import mpmath
from sympy import QQ, ring


def check(names, left, right, relations, d, definitions={}, functions={}, variables={}):
    """Prints d*N - (q1*p1 + q2*p2 + ...), which is 0, with N and p1, p2, ... computed from what stands above.

    An expression is a quotient of polynomials, top and under: sums get a common denominator, nothing is cancelled.
    N is the top of left - right, with whole coefficients; p is the same of the two sides of a relation.
    """
    space, *generators = ring(names or ["unused"], QQ)
    known = {name: (generator, space.one) for name, generator in zip(names, generators)}
    plain = {ast.unparse(ast.parse(call, mode="eval")): image for call, image in functions.items()}
    found = {}

    def quotient(text):
        if text not in found:
            found[text] = walk(ast.parse(text, mode="eval").body)
        return found[text]

    def walk(node):
        if isinstance(node, ast.Constant) and type(node.value) is int:
            return space(node.value), space.one
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            top, under = walk(node.operand)
            return -top, under
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
            (top, under), power = walk(node.left), ast.literal_eval(node.right)
            top, under = (under, top) if power < 0 else (top, under)
            return top ** abs(power), under ** abs(power)
        if isinstance(node, ast.BinOp):
            (a, b), (c, e) = walk(node.left), walk(node.right)
            if isinstance(node.op, ast.Mult):
                return a * c, b * e
            if isinstance(node.op, ast.Div):
                return a * e, b * c
            sign = {ast.Add: 1, ast.Sub: -1}[type(node.op)]
            return (a + sign * c, b) if b == e else (a * e + sign * c * b, b * e)
        text = ast.unparse(node)
        if text in plain:
            return quotient(plain[text])
        if text in definitions:
            return quotient(definitions[text])
        if text in known:
            return known[text]
        raise ValueError(f"nothing is known of {text}")

    def top(left, right):
        (a, b), (c, e) = quotient(left), quotient(right)
        if not b or not e:
            raise ZeroDivisionError(f"{left} = {right} has no value anywhere")
        difference = a - c if b == e else a * e - c * b
        return difference.clear_denoms()[1] if difference else difference

    numbers_agree(names, plain, definitions, variables)
    N = top(left, right)
    combination = sum((quotient(q)[0] * top(a, b) for a, b, q in relations), space.zero)
    if not quotient(d)[0]:
        raise ZeroDivisionError("d is 0")
    difference = quotient(d)[0] * N - combination
    print(difference)
    if difference:
        sys.exit(1)


def real(function, allowed=lambda *a: True):
    def call(*arguments):
        if not allowed(*arguments):
            raise ValueError("no real value")
        return function(*arguments)

    return call


REAL = {
    "sqrt": real(mpmath.sqrt, lambda x: x >= 0), "Abs": abs, "sin": mpmath.sin, "cos": mpmath.cos, "tan": mpmath.tan,
    "exp": mpmath.exp, "log": real(mpmath.log, lambda x: x > 0), "sinh": mpmath.sinh, "cosh": mpmath.cosh,
    "tanh": mpmath.tanh, "asin": real(mpmath.asin, lambda x: abs(x) <= 1), "acos": real(mpmath.acos, lambda x: abs(x) <= 1),
    "atan": mpmath.atan, "atan2": mpmath.atan2, "agm": real(mpmath.agm, lambda x, y: x > 0 and y > 0),
    "power": real(mpmath.power, lambda x, y: x > 0),
}


def numbers_agree(names, functions, definitions, variables):
    """At random numbers, each call of a function has the value of what stands for it: to 40 digits."""
    mpmath.mp.dps = 50
    random.seed(1)
    free = [name for name in names if name not in variables and name not in definitions]
    good = 0
    for _ in range(400 if functions else 0):
        scale = random.choice([1, 10, 100])
        values = {name: mpmath.mpf(random.randint(-99, 99)) / (random.randint(50, 99) * scale) for name in free}
        values = {name: abs(value) if random.random() < 0.5 else value for name, value in values.items()}

        def number(text):
            return walk(ast.parse(text, mode="eval").body)

        def walk(node):
            if isinstance(node, ast.Constant):
                return mpmath.mpf(node.value)
            if isinstance(node, ast.UnaryOp):
                return -walk(node.operand)
            if isinstance(node, ast.BinOp):
                if isinstance(node.op, ast.Pow):
                    return walk(node.left) ** ast.literal_eval(node.right)
                a, b = walk(node.left), walk(node.right)
                return {ast.Add: lambda: a + b, ast.Sub: lambda: a - b, ast.Mult: lambda: a * b, ast.Div: lambda: a / b}[
                    type(node.op)
                ]()
            if isinstance(node, ast.Call):
                return REAL[node.func.id](*map(walk, node.args))
            name = node.id
            if name == "pi":
                return +mpmath.pi
            if name not in values:
                values[name] = number(variables[name] if name in variables else definitions[name])
            return values[name]

        try:
            pairs = [(call, number(call), number(image)) for call, image in functions.items()]
        except (ValueError, ZeroDivisionError):
            continue
        for call, one, other in pairs:
            if abs(one - other) > mpmath.mpf(10) ** -40 * (1 + abs(one)):
                sys.exit(f"{call} is not {functions[call]}")
        good += 1
        if good == 3:
            return
    if functions and not good:
        sys.exit("no numbers were found for which the functions have values")


# Equation 1: (an expression of 153 operations) = -({\bf j}_1(x,y,z,t)\cdot {\bf E}_1(x,y,z,t)+{\bf j}_2(x,y,z,t)\cdot {\bf E}_2(x,y,z,t)+{\bf j}_3(x,y,z,t)\cdot {\bf E}_3(x,y,z,t))
# jxyzt3 stands for {\bf j}_3(x,y,z,t)
# jxyzt2 stands for {\bf j}_2(x,y,z,t)
# jxyzt1 stands for {\bf j}_1(x,y,z,t)
# Exyzt3_dt stands for \frac{\partial {\bf E}_3(x,y,z,t)}{\partial t}
# Exyzt2_dt stands for \frac{\partial {\bf E}_2(x,y,z,t)}{\partial t}
# Exyzt1_dt stands for \frac{\partial {\bf E}_1(x,y,z,t)}{\partial t}
# varepsilon stands for \varepsilon
# mu stands for \mu
# Bxyzt1_dy stands for \frac{\partial {\bf B}_1(x,y,z,t)}{\partial y}
# Bxyzt2_dx stands for \frac{\partial {\bf B}_2(x,y,z,t)}{\partial x}
# Bxyzt3_dx stands for \frac{\partial {\bf B}_3(x,y,z,t)}{\partial x}
# Bxyzt1_dz stands for \frac{\partial {\bf B}_1(x,y,z,t)}{\partial z}
# Bxyzt2_dz stands for \frac{\partial {\bf B}_2(x,y,z,t)}{\partial z}
# Bxyzt3_dy stands for \frac{\partial {\bf B}_3(x,y,z,t)}{\partial y}
# Bxyzt3_dt stands for \frac{\partial {\bf B}_3(x,y,z,t)}{\partial t}
# Bxyzt2_dt stands for \frac{\partial {\bf B}_2(x,y,z,t)}{\partial t}
# Bxyzt1_dt stands for \frac{\partial {\bf B}_1(x,y,z,t)}{\partial t}
# Exyzt1_dy stands for \frac{\partial {\bf E}_1(x,y,z,t)}{\partial y}
# Exyzt2_dx stands for \frac{\partial {\bf E}_2(x,y,z,t)}{\partial x}
# Exyzt3_dx stands for \frac{\partial {\bf E}_3(x,y,z,t)}{\partial x}
# Exyzt1_dz stands for \frac{\partial {\bf E}_1(x,y,z,t)}{\partial z}
# Exyzt2_dz stands for \frac{\partial {\bf E}_2(x,y,z,t)}{\partial z}
# Exyzt3_dy stands for \frac{\partial {\bf E}_3(x,y,z,t)}{\partial y}
# Bxyzt3 stands for {\bf B}_3(x,y,z,t)
# Bxyzt2 stands for {\bf B}_2(x,y,z,t)
# Bxyzt1 stands for {\bf B}_1(x,y,z,t)
# Exyzt3 stands for {\bf E}_3(x,y,z,t)
# Exyzt2 stands for {\bf E}_2(x,y,z,t)
# Exyzt1 stands for {\bf E}_1(x,y,z,t)
check(
    names=["Bxyzt1_dy_dz", "Exyzt3_dz_dt", "Exyzt2_dy_dt", "Exyzt1_dx_dt", "Bxyzt2_dx_dz", "Bxyzt3_dx_dy", "Exyzt1_dy_dz", "Bxyzt3_dz_dt", "Bxyzt2_dy_dt", "Bxyzt1_dx_dt", "Exyzt2_dx_dz", "Exyzt3_dx_dy", "jxyzt3_dz", "jxyzt2_dy", "jxyzt1_dx", "rhoxyzt_dt", "jxyzt3", "jxyzt2", "jxyzt1", "rhoxyzt", "Exyzt3_dt", "Exyzt2_dt", "Exyzt1_dt", "varepsilon", "mu", "Bxyzt1_dy", "Bxyzt2_dx", "Bxyzt3_dx", "Bxyzt1_dz", "Bxyzt2_dz", "Bxyzt3_dy", "Bxyzt3_dt", "Bxyzt2_dt", "Bxyzt1_dt", "Exyzt1_dy", "Exyzt2_dx", "Exyzt3_dx", "Exyzt1_dz", "Exyzt2_dz", "Exyzt3_dy", "Bxyzt3_dz", "Bxyzt2_dy", "Bxyzt1_dx", "Bxyzt3", "Bxyzt2", "Bxyzt1", "Exyzt3_dz", "Exyzt2_dy", "Exyzt1_dx", "Exyzt3", "Exyzt2", "Exyzt1"],
    left="varepsilon/2*(Exyzt1_dt*Exyzt1 + Exyzt1_dt*Exyzt1 + (Exyzt2_dt*Exyzt2 + Exyzt2_dt*Exyzt2) + (Exyzt3_dt*Exyzt3 + Exyzt3_dt*Exyzt3)) + 1/(2*mu)*(Bxyzt1_dt*Bxyzt1 + Bxyzt1_dt*Bxyzt1 + (Bxyzt2_dt*Bxyzt2 + Bxyzt2_dt*Bxyzt2) + (Bxyzt3_dt*Bxyzt3 + Bxyzt3_dt*Bxyzt3)) + (1/mu*Exyzt2_dx*Bxyzt3 + 1/mu*Exyzt2*Bxyzt3_dx - (1/mu*Exyzt3_dx*Bxyzt2 + 1/mu*Exyzt3*Bxyzt2_dx) + (1/mu*Exyzt3_dy*Bxyzt1 + 1/mu*Exyzt3*Bxyzt1_dy - (1/mu*Exyzt1_dy*Bxyzt3 + 1/mu*Exyzt1*Bxyzt3_dy)) + (1/mu*Exyzt1_dz*Bxyzt2 + 1/mu*Exyzt1*Bxyzt2_dz - (1/mu*Exyzt2_dz*Bxyzt1 + 1/mu*Exyzt2*Bxyzt1_dz)))",
    right="-(jxyzt1*Exyzt1 + jxyzt2*Exyzt2 + jxyzt3*Exyzt3)",
    relations=[
        # because of what is given: \frac{\partial {\bf E}_3(x,y,z,t)}{\partial y}-\frac{\partial {\bf E}_2(x,y,z,t)}{\partial z} = -\frac{\partial {\bf B}_1(x,y,z,t)}{\partial t}
        ("Exyzt3_dy - Exyzt2_dz", "-Bxyzt1_dt", "4*mu*Bxyzt1"),
        # because of what is given: \frac{\partial {\bf E}_1(x,y,z,t)}{\partial z}-\frac{\partial {\bf E}_3(x,y,z,t)}{\partial x} = -\frac{\partial {\bf B}_2(x,y,z,t)}{\partial t}
        ("Exyzt1_dz - Exyzt3_dx", "-Bxyzt2_dt", "4*mu*Bxyzt2"),
        # because of what is given: \frac{\partial {\bf E}_2(x,y,z,t)}{\partial x}-\frac{\partial {\bf E}_1(x,y,z,t)}{\partial y} = -\frac{\partial {\bf B}_3(x,y,z,t)}{\partial t}
        ("Exyzt2_dx - Exyzt1_dy", "-Bxyzt3_dt", "4*mu*Bxyzt3"),
        # because of what is given: \frac{\partial {\bf B}_3(x,y,z,t)}{\partial y}-\frac{\partial {\bf B}_2(x,y,z,t)}{\partial z} = \mu\cdot {\bf j}_1(x,y,z,t)+\mu\cdot \varepsilon\cdot \frac{\partial {\bf E}_1(x,y,z,t)}{\partial t}
        ("Bxyzt3_dy - Bxyzt2_dz", "mu*jxyzt1 + mu*varepsilon*Exyzt1_dt", "-4*mu*Exyzt1"),
        # because of what is given: \frac{\partial {\bf B}_1(x,y,z,t)}{\partial z}-\frac{\partial {\bf B}_3(x,y,z,t)}{\partial x} = \mu\cdot {\bf j}_2(x,y,z,t)+\mu\cdot \varepsilon\cdot \frac{\partial {\bf E}_2(x,y,z,t)}{\partial t}
        ("Bxyzt1_dz - Bxyzt3_dx", "mu*jxyzt2 + mu*varepsilon*Exyzt2_dt", "-4*mu*Exyzt2"),
        # because of what is given: \frac{\partial {\bf B}_2(x,y,z,t)}{\partial x}-\frac{\partial {\bf B}_1(x,y,z,t)}{\partial y} = \mu\cdot {\bf j}_3(x,y,z,t)+\mu\cdot \varepsilon\cdot \frac{\partial {\bf E}_3(x,y,z,t)}{\partial t}
        ("Bxyzt2_dx - Bxyzt1_dy", "mu*jxyzt3 + mu*varepsilon*Exyzt3_dt", "-4*mu*Exyzt3"),
    ],
    d="1",
)
