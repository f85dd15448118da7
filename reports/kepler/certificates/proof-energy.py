# -*- coding: utf-8 -*-
# kepler / energy: The energy per unit mass does not change.
#
# Given: the definitions, the assumptions and kepler.
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


# Equation 1: \dot{h} = 0
# where \dot{h} = (an expression of 205 operations)
# root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}
check(
    names=["root", "r3_dot", "r2_dot", "r1_dot", "mu", "r3", "r2", "r1", "h_dot"],
    left="h_dot",
    right="0",
    relations=[
    ],
    d="1",
    definitions={
        "h_dot": "1/2*(-(mu/sqrt(r1*r1 + r2*r2 + r3*r3)**3*r1))*r1_dot + 1/2*r1_dot*(-(mu/sqrt(r1*r1 + r2*r2 + r3*r3)**3*r1)) + (1/2*(-(mu/sqrt(r1*r1 + r2*r2 + r3*r3)**3*r2))*r2_dot + 1/2*r2_dot*(-(mu/sqrt(r1*r1 + r2*r2 + r3*r3)**3*r2))) + (1/2*(-(mu/sqrt(r1*r1 + r2*r2 + r3*r3)**3*r3))*r3_dot + 1/2*r3_dot*(-(mu/sqrt(r1*r1 + r2*r2 + r3*r3)**3*r3))) - (-(mu/sqrt(r1*r1 + r2*r2 + r3*r3)*((r1_dot*r1 + r1_dot*r1 + (r2_dot*r2 + r2_dot*r2) + (r3_dot*r3 + r3_dot*r3))/(2*sqrt(r1*r1 + r2*r2 + r3*r3)))))/sqrt(r1*r1 + r2*r2 + r3*r3)",
    },
    functions={
        "sqrt(r1*r1 + r2*r2 + r3*r3)": "root",
    },
    variables={
        "root": "sqrt(r1*r1 + r2*r2 + r3*r3)",
    },
)
